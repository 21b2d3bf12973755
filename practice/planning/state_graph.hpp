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

#include "practice/planning/skill_task.hpp"
#include "search/state/state_registry.hpp"

namespace praxis::practice {

using NodeIndex = std::uint32_t;

class StateGraph {
  public:
    struct Edge {
        SkillIndex skill;
        NodeIndex node;  ///< forward: where it leads to; backward: where it comes from
    };

    /// `relevant`: by variable, whether it matters (see `relevant_variables`). States that agree in those are
    /// one node, and skills that change none of them have no edges.
    StateGraph(const SkillTask& skills, std::span<const unsigned char> relevant, std::size_t most_states);

    /// All variables matter.
    StateGraph(const SkillTask& skills, std::size_t most_states)
        : StateGraph(skills, std::vector<unsigned char>(skills.task().variable_count(), 1), most_states) {}

    /// The node of a state, and all that is reachable from it. False: the limit was reached; the graph is of
    /// no use any more.
    bool reach(const std::vector<std::int32_t>& values, NodeIndex& node);
    bool overflowed() const { return overflowed_; }

    std::size_t size() const { return registry_.size(); }
    std::size_t edge_count() const { return edges_.size(); }
    std::span<const Edge> forward(NodeIndex node) const {
        return {edges_.data() + first_edge_[node], edges_.data() + first_edge_[node + 1]};
    }
    std::span<const Edge> backward(NodeIndex node) const {
        return {backward_.data() + first_backward_[node], backward_.data() + first_backward_[node + 1]};
    }
    /// The edges of one skill: pairs of nodes (from, to).
    struct Arc {
        NodeIndex from, to;
    };
    std::span<const Arc> arcs(SkillIndex skill) const {
        return {arcs_.data() + first_arc_[skill], arcs_.data() + first_arc_[skill + 1]};
    }
    const FiniteDomainTask& task() const { return skills_->task(); }
    /// Of a variable that is not derived.
    std::int32_t value(NodeIndex node, std::int32_t variable) const {
        return parts_->packer.get(registry_.words(StateId(node)), variable);
    }
    /// The nodes where all facts hold.
    std::vector<NodeIndex> where(std::span<const Fact> facts) const;

  private:
    void expand_all();
    void index_edges();

    const SkillTask* skills_;
    const PreparedTask::Parts* parts_;
    StateRegistry registry_;
    std::size_t most_states_;
    bool overflowed_ = false;
    std::vector<Fact> fixed_;             // variables that do not matter, at their initial values
    std::vector<unsigned char> matters_;  // by skill
    std::vector<std::size_t> first_edge_;
    std::vector<Edge> edges_;
    std::vector<std::size_t> first_backward_;
    std::vector<Edge> backward_;
    std::vector<std::size_t> first_arc_;
    std::vector<Arc> arcs_;
};

}  // namespace praxis::practice
