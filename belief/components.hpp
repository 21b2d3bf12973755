// Uncertain variables whose relations matter beyond the first state.
//
// Knowing literals is enough as long as no effect depends on something unknown (Bonet and Geffner's *simple*
// problems). Where one does, the variables that it joins, and those joined with them by clauses, make a
// *component*, and every way that they may be, a *case*. Components whose cases can be counted are tracked
// case by case: exactly in the belief, and for a sample of the cases in plans (as Brafman and Shani's SDR
// does, 2012).
#pragma once

#include <cstdint>
#include <vector>

#include "belief/belief_task.hpp"

namespace praxis::belief {

/// The cases of a component: rows of values, one a case, in the order of the variables.
struct Component {
    std::vector<std::int32_t> variables;  ///< of the physical task; increasing
    std::vector<std::int8_t> cases;       ///< size: variables times cases

    std::size_t count() const { return variables.empty() ? 0 : cases.size() / variables.size(); }
};

struct Components {
    std::vector<Component> tracked;
    /// By physical variable: its component, and its column there; kNone if it is not tracked.
    std::vector<std::uint32_t> component_of;
    std::vector<std::uint32_t> column_of;
    static constexpr std::uint32_t kNone = 0xffffffff;
};

/// Components with at most `most_cases` cases at first; larger ones are not tracked.
Components find_components(const BeliefTask& task, std::size_t most_cases);

}  // namespace praxis::belief
