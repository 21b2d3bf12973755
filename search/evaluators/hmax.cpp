#include "search/evaluators/hmax.hpp"

namespace praxis {

HmaxEvaluator::HmaxEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : HmaxEvaluator(
          task, std::make_shared<const RelaxedTask>(task, goal, cost_type, RelaxedTask::Dominance::drop)) {}

HmaxEvaluator::HmaxEvaluator(const FiniteDomainTask&, std::shared_ptr<const RelaxedTask> relaxed)
    : exploration_(std::move(relaxed)) {}

}  // namespace praxis
