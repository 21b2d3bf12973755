// Cheapest ways through a graph of states (Dijkstra 1959), and how they change when one skill becomes
// cheaper.
//
// An object is scratch memory for one thread; it grows to the graph once and is used again without being
// cleared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "practice/planning/state_graph.hpp"
#include "practice/planning/success_cost.hpp"

namespace praxis::practice {

class ShortestPaths {
  public:
    explicit ShortestPaths(const StateGraph& graph) : graph_(&graph) {}

    /// By node, the cost of the cheapest plan to a goal node; kNoPlan where there is none. `costs`: by skill.
    void to_goals(std::span<const NodeIndex> goals, std::span<const Cost> costs,
                  std::vector<Cost>& distances);

    /// A cheapest way from one node to the nearest node where all facts hold. False: there is none.
    bool way(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
             std::vector<SkillIndex>& skills, Cost& cost);

    /// What the distances of some nodes would be if `skill` cost `cost`, less than before; `distances` are
    /// those that `to_goals` found. Only the nodes that come nearer are looked at, the nearest to the goal
    /// first (after Ramalingam and Reps 1996), until no node asked for can change. `result`: by entry of
    /// `nodes`.
    void cheaper(std::span<const Cost> distances, std::span<const Cost> costs, SkillIndex skill, Cost cost,
                 std::span<const NodeIndex> nodes, std::span<Cost> result);

  private:
    struct Entry {
        Cost distance;
        NodeIndex node;
        friend bool operator>(const Entry& a, const Entry& b) {
            return a.distance != b.distance ? a.distance > b.distance : a.node > b.node;
        }
    };
    void push(Cost distance, NodeIndex node);
    Entry pop();
    /// Forgets the scratch distances.
    void begin();
    bool seen(NodeIndex node) const { return stamps_[node] == stamp_; }

    const StateGraph* graph_;
    std::vector<Entry> heap_;
    std::uint32_t stamp_ = 0;
    std::vector<std::uint32_t> stamps_;  // by node: `scratch_` is of now
    std::vector<Cost> scratch_;          // by node
    std::vector<std::pair<NodeIndex, SkillIndex>> parents_;
    std::vector<std::uint32_t> goal_stamps_;
};

}  // namespace praxis::practice
