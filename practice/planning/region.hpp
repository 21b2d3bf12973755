// The part of a large graph of states where a task's plans can be that an improvement makes cheaper.
//
// If every skill costs at least its `lower` cost, a plan of less than the present cost passes only nodes that
// are nearer than that to the beginning. All improvements are answered inside of this part, exactly.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "practice/planning/shortest_paths.hpp"

namespace praxis::practice {

/// What if a skill cost this?
struct Improvement {
    SkillIndex skill;
    Cost cost;
};

/// Scratch memory for one thread, over one graph that must outlive it and may grow.
class Region {
  public:
    explicit Region(const SkillGraph& graph) : graph_(&graph), whole_(graph), part_(inside_) {}

    /// The cost of the cheapest plan from a node to one of the `goals` (sorted); kNoPlan: there is none.
    Cost begin(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs);
    /// Makes the part for the plan that `begin` found. False: it has more than `most` nodes.
    bool make(std::span<const NodeIndex> goals, std::span<const Cost> costs, std::span<const Cost> lower,
              std::size_t most);
    /// The cost of the cheapest plan with an improvement, after `make`; the improved cost is not below
    /// `lower`.
    Cost improved(std::span<const Cost> costs, std::span<const NodeIndex> goals,
                  const Improvement& improvement);

  private:
    const SkillGraph* graph_;
    ShortestPaths whole_;
    SkillGraph inside_;
    ShortestPaths part_;
    NodeIndex from_ = 0;
    Cost cost_ = 0;
    std::vector<SkillIndex> plan_;
    std::vector<NodeIndex> nodes_;  // of the part, nearest first
    std::vector<NodeIndex>
        numbers_;  // by node of the whole: its number in the part, where `nodes_` confirms it
    std::vector<NodeIndex> goals_;  // in the part
    std::vector<Cost> distances_;   // to them
};

}  // namespace praxis::practice
