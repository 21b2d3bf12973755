// Cheapest ways through a graph of states (Dijkstra 1959).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "practice/planning/node_costs.hpp"

namespace praxis::practice {

/// Scratch memory for one thread.
class ShortestPaths {
  public:
    explicit ShortestPaths(const StateGraph& graph) : graph_(&graph) {}

    /// By node, the cost of the cheapest plan to a goal node; kNoPlan where there is none. `costs`: by skill.
    void to_goals(std::span<const NodeIndex> goals, std::span<const Cost> costs,
                  std::vector<Cost>& distances);

    /// A cheapest way from one node to one of `goals`. False: there is none.
    bool way(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
             std::vector<SkillIndex>& skills, Cost& cost);

    /// Nodes that the last `way` has looked at.
    std::size_t looked_at() const { return looked_at_; }

  private:
    std::size_t looked_at_ = 0;
    const StateGraph* graph_;
    NodeQueue queue_;
    NodeCosts costs_, goals_;
    std::vector<std::pair<NodeIndex, SkillIndex>> parents_;  // by node
};

}  // namespace praxis::practice
