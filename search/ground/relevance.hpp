// What cannot matter for the goal.
#pragma once

#include "search/task/finite_domain_task.hpp"

namespace praxis::grounding {

/// The task without the variables from which no path of the causal graph leads to the goal, and without the
/// operators and axioms that are then without effect.
FiniteDomainTask without_irrelevant(FiniteDomainTask task);

}  // namespace praxis::grounding
