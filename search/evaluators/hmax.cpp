#include "search/evaluators/hmax.hpp"

namespace praxis {

HmaxEvaluator::HmaxEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : exploration_(std::make_shared<const RelaxedTask>(task, goal, cost_type, RelaxedTask::Dominance::drop)) {
}

}  // namespace praxis
