// Whether a plan is valid by the textbook semantics (see naive_semantics.hpp). A second opinion for the
// validator's tests.
#pragma once

#include <cstddef>

#include "search/plan.hpp"

namespace praxis::test {

/// 0: the plan is valid; otherwise the 1-based step that cannot be executed, or steps + 1 for the goal.
std::size_t naive_failure(const LiftedTask& task, const Plan& plan);

}  // namespace praxis::test
