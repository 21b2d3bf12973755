#include "search/evaluators/hadd.hpp"

namespace praxis {

AddEvaluator::AddEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : AddEvaluator(
          task, std::make_shared<const RelaxedTask>(task, goal, cost_type, RelaxedTask::Dominance::drop)) {}

AddEvaluator::AddEvaluator(const FiniteDomainTask& task, std::shared_ptr<const RelaxedTask> relaxed)
    : exploration_(std::move(relaxed)), plan_(task, exploration_.task()) {}

Estimate AddEvaluator::evaluate(StateView state) {
    preferred_ = {};
    const Estimate estimate = exploration_.run(state);
    if (preferred_wanted_ && estimate != kDeadEnd) {
        plan_.extract(exploration_, state);
        preferred_ = plan_.preferred();
    }
    return estimate;
}

}  // namespace praxis
