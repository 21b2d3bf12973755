// Operator costs as a component counts them.
#pragma once

#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// The cost of every operator by `cost_type`; saturates below kDeadEnd.
std::vector<std::int32_t> operator_costs(const FiniteDomainTask& task, CostType cost_type);

}  // namespace praxis
