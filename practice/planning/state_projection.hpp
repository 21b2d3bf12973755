// The states of a graph seen through a few variables only: a small graph whose distances bound those of the
// large one from below (Culberson and Schaeffer 1998, "pattern databases").
//
// Two states are one if these variables have the same values; an edge leads from one projected state to
// another if a skill does somewhere. The projection depends neither on costs nor on goals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "practice/planning/node_costs.hpp"

namespace praxis::practice {

class StateProjection {
  public:
    static constexpr std::size_t kMostStates = 1000;

    /// Onto a variable that is not derived and has no more than `kMostStates` values, and those that skills
    /// which change it depend on, the most frequent first, as long as there are no more than `kMostStates`
    /// projected states.
    StateProjection(const StateGraph& graph, std::int32_t variable);

    std::uint32_t state(NodeIndex node) const { return states_[node]; }
    /// Nodes of the graph when the projection was made.
    std::size_t nodes() const { return states_.size(); }

    /// By projected state, the cost of the cheapest way to one where the variable has this value.
    std::vector<Cost> distances(Fact goal, std::span<const Cost> costs) const;

  private:
    struct Edge {
        std::uint32_t from, to;
        SkillIndex skill;
    };
    void project(const StateGraph& graph, std::span<const std::int32_t> variables);
    void collect_edges(const StateGraph& graph);

    std::size_t size_ = 1;                 // projected states
    std::size_t domain_;                   // of the variable; it is the fastest digit of a state's number
    std::vector<std::uint32_t> states_;    // by node
    std::vector<Edge> edges_;              // by `to`
    std::vector<std::size_t> first_edge_;  // by `to`; one more at the end
};

}  // namespace praxis::practice
