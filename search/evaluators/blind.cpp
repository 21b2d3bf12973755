#include "search/evaluators/blind.hpp"

#include <algorithm>

#include "search/evaluators/operator_costs.hpp"

namespace praxis {

BlindEvaluator::BlindEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : goal_(goal.begin(), goal.end()) {
    const std::vector<std::int32_t> costs = operator_costs(task, cost_type);
    if (!costs.empty()) cheapest_ = *std::ranges::min_element(costs);
}

Estimate BlindEvaluator::evaluate(StateView state) {
    return all_hold(goal_, state.data()) ? 0 : cheapest_;
}

}  // namespace praxis
