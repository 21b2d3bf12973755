// The symbolic states that skills lead through, as a graph: states once met are never expanded again,
// whatever the costs, the goal and the initial state.
//
// Nodes are numbered in the order of discovery; an edge is a ground skill and the node it leads to if it
// succeeds. Practising asks for thousands of plans over one set of states, so that the graph is made once and
// plans become shortest paths in it. It has a limit: of a task with more states than that, `reach` says so,
// and plans come from a search.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "practice/planning/skill_graph.hpp"
#include "search/state/state_registry.hpp"

namespace praxis::practice {

class StateGraph {
  public:
    StateGraph(const SkillTask& skills, std::size_t most_states);

    /// The node of a state, and all that is reachable from it. False: the limit was reached; the graph is of
    /// no use any more.
    bool reach(const std::vector<std::int32_t>& values, NodeIndex& node);
    bool overflowed() const { return overflowed_; }

    std::size_t size() const { return registry_.size(); }
    const SkillGraph& graph() const { return graph_; }
    /// The nodes where all facts hold.
    std::vector<NodeIndex> where(std::span<const Fact> facts) const;

  private:
    void expand_all();

    const SkillTask* skills_;
    const PreparedTask::Parts* parts_;
    StateRegistry registry_;
    std::size_t most_states_;
    bool overflowed_ = false;
    SkillGraph graph_;
};

}  // namespace praxis::practice
