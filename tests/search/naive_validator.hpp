// The textbook semantics of a plan, as simply as it can be written: sets of tuples, every quantifier a loop
// over its type, axioms by repeated passes. A second opinion for the validator's tests; shares no code with
// it.
#pragma once

#include <cstddef>

#include "search/plan.hpp"

namespace praxis::test {

/// 0: the plan is valid; otherwise the 1-based step that cannot be executed, or steps + 1 for the goal.
std::size_t naive_failure(const LiftedTask& task, const Plan& plan);

}  // namespace praxis::test
