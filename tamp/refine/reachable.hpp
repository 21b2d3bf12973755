// Whether a goal is out of reach for a simple reason: some actions are never possible, and without them even
// a plan that loses nothing it once had does not get there.
//
// That is more than that this symbolic task has no plan. A placeholder stands for one value in a plan; a plan
// may need several values of the same kind. But where all values fail, copies of the placeholder fail, too;
// and a plan with copies, its copies taken for one, would be a plan that loses nothing.
#pragma once

#include <vector>

#include "tamp/refine/symbolic.hpp"

namespace praxis::tamp {

/// Whether the goal is reached in the relaxation of the ground task (facts once reached stay) without some
/// operators, given by number.
bool is_goal_reachable(const FiniteDomainTask& task, const std::vector<bool>& forbidden);

/// No action asks whether two of its arguments are the same: then copies of a placeholder may be taken for
/// one.
bool is_free_of_equality(const LiftedTask& task);

}  // namespace praxis::tamp
