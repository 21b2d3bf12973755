#include "search/evaluators/operator_costs.hpp"

#include <algorithm>

namespace praxis {

std::vector<std::int32_t> operator_costs(const FiniteDomainTask& task, CostType cost_type) {
    if (cost_type == CostType::one) return std::vector<std::int32_t>(task.operator_count(), 1);
    std::vector<std::int32_t> costs = task.costs;
    const bool all_one = std::ranges::all_of(costs, [](std::int32_t cost) { return cost == 1; });
    const std::int32_t extra = cost_type == CostType::plus_one && !all_one ? 1 : 0;
    for (std::int32_t& cost : costs) cost = std::min(cost, kDeadEnd - 2) + extra;
    return costs;
}

}  // namespace praxis
