#include "search/evaluators/goal_count.hpp"

namespace praxis {

GoalCountEvaluator::GoalCountEvaluator(const FiniteDomainTask&, std::span<const Fact> goal, CostType)
    : goal_(goal.begin(), goal.end()) {}

Estimate GoalCountEvaluator::evaluate(StateView state) {
    Estimate open = 0;
    for (const Fact fact : goal_) open += state[static_cast<std::size_t>(fact.variable)] != fact.value;
    return open;
}

}  // namespace praxis
