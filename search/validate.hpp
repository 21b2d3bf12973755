// The independent check of a plan: it executes the plan on the lifted task's formulas as they were written
// (ADL, axioms by stratified fixpoints, exact costs) and shares nothing with the grounder or the search.
#pragma once

#include <string>

#include "search/plan.hpp"

namespace praxis {

struct Verdict {
    bool valid = false;
    Rational cost;  ///< of the steps executed
    std::size_t step =
        0;  ///< 1-based number of the step that fails; steps + 1: the goal; 0: the plan is valid
    /// If invalid: which action fails and which part of its condition (or of the goal), as people would say
    /// it, with the formula as written in the source.
    std::string reason;
};

/// Executes `plan` from the initial state.
Verdict validate(const LiftedTask& task, const Plan& plan);

}  // namespace praxis
