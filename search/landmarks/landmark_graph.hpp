// Landmarks of a task and orderings between them.
//
// A *landmark* is a set of facts of which some one holds at some time in every plan; here one fact, or a
// *disjunctive* landmark of two to four. Landmark A is ordered before landmark B
//
//     greedy-necessarily  if A holds in the state just before B first does,
//     naturally           if A holds in some state before B first does,
//     reasonably          if, should B be reached first, it must be given up again to reach A.
//
// Derived variables take their value in the same step as the facts they follow from: for a B with a derived
// fact "before" means "not later than", and the state just before is the state itself.
//
// Found by backchaining from the goal as in Richter, Helmert and Westphal, "Landmarks Revisited" (AAAI 2008),
// and Richter and Westphal, "The LAMA Planner" (JAIR 2010); reasonable orderings as in Hoffmann, Porteous and
// Sebastia, "Ordered Landmarks in Planning" (JAIR 2004). A graph that was cut short is smaller, not wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "search/budget.hpp"
#include "search/task/finite_domain_task.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis {

/// From weak to strong.
enum class LandmarkOrdering : std::uint8_t { reasonable, natural, greedy_necessary };

struct LandmarkOptions {
    bool disjunctive = true;
    bool reasonable = true;
    /// Elementary steps (a rule's precondition looked at, say); some 10^8 a second.
    std::uint64_t work = 500'000'000;
    Budget budget = {};
};

/// Landmarks are numbered such that all orderings lead from lower to higher numbers.
struct LandmarkGraph {
    struct Neighbour {
        std::uint32_t landmark;
        LandmarkOrdering ordering;
    };

    std::size_t size() const { return facts.size(); }
    std::size_t ordering_count() const { return predecessors.total(); }
    std::size_t ordering_count(LandmarkOrdering ordering) const;
    bool disjunctive(std::size_t landmark) const { return facts[landmark].size() > 1; }
    /// Some fact of the landmark holds.
    bool holds(std::size_t landmark, std::span<const std::int32_t> values) const {
        for (const Fact fact : facts[landmark]) {
            if (values[static_cast<std::size_t>(fact.variable)] == fact.value) return true;
        }
        return false;
    }

    PackedLists<Fact> facts;              ///< by landmark
    std::vector<char> goal;               ///< by landmark: it is a fact of the goal
    std::vector<char> initial;            ///< by landmark: holds initially
    std::vector<char> derived;            ///< by landmark: has a fact of a derived variable
    PackedLists<Neighbour> predecessors;  ///< by landmark; increasing
    PackedLists<Neighbour> successors;    ///< by landmark; increasing
    /// By landmark B: landmarks A that were ordered reasonably before B, in a cycle with stronger orderings.
    /// B must hold before A and be reached once more after it.
    PackedLists<std::uint32_t> undone_by;
    PackedLists<std::uint32_t> first_achievers;  ///< by landmark: operators that may be first to reach it
    bool complete = true;                        ///< not cut short
};

/// `initial_values`: derived variables at any value, they are derived anew.
LandmarkGraph make_landmark_graph(const FiniteDomainTask& task, std::span<const Fact> goal,
                                  std::span<const std::int32_t> initial_values,
                                  const LandmarkOptions& options = {});

}  // namespace praxis
