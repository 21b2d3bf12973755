// Costs of nodes while a graph is searched, and the queue that says which is next.
//
// Both are scratch memory: they grow to the graph once and are used again without being cleared.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "practice/planning/state_graph.hpp"
#include "practice/planning/success_cost.hpp"

namespace praxis::practice {

/// A cost by node; kNoPlan where none was set since `reset`.
class NodeCosts {
  public:
    void reset(std::size_t nodes) {
        if (++now_ == 0) {
            entries_.clear();
            now_ = 1;
        }
        entries_.resize(nodes);
    }
    Cost operator[](NodeIndex node) const {
        return entries_[node].set == now_ ? entries_[node].cost : kNoPlan;
    }
    void set(NodeIndex node, Cost cost) { entries_[node] = {cost, now_}; }
    /// False: it was as low before.
    bool lower(NodeIndex node, Cost cost) {
        if (cost >= (*this)[node]) return false;
        set(node, cost);
        return true;
    }

  private:
    struct Entry {
        Cost cost = 0;
        std::uint32_t set = 0;
    };
    std::vector<Entry> entries_;
    std::uint32_t now_ = 0;
};

/// Nodes by cost, the cheapest first; of equal ones that with the lower number.
class NodeQueue {
  public:
    struct Entry {
        Cost cost;
        NodeIndex node;
        friend bool operator>(const Entry& a, const Entry& b) {
            return a.cost != b.cost ? a.cost > b.cost : a.node > b.node;
        }
    };
    bool empty() const { return heap_.empty(); }
    void clear() { heap_.clear(); }
    void push(Cost cost, NodeIndex node) {
        heap_.push_back({cost, node});
        std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
    }
    Entry pop() {
        std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
        const Entry entry = heap_.back();
        heap_.pop_back();
        return entry;
    }

  private:
    std::vector<Entry> heap_;
};

}  // namespace praxis::practice
