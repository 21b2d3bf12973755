// Which variables matter for a goal.
#pragma once

#include <span>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis::practice {

/// By variable, 1 if it is in the goal, or in the precondition or an effect's condition of an operator that
/// changes a variable that matters; a plan for the goal never needs to look at the others. With axioms all
/// variables matter.
std::vector<unsigned char> relevant_variables(const FiniteDomainTask& task, std::span<const Fact> goal);

}  // namespace praxis::practice
