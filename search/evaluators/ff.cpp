#include "search/evaluators/ff.hpp"

namespace praxis {

FFEvaluator::FFEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : FFEvaluator(task,
                  std::make_shared<const RelaxedTask>(task, goal, cost_type, RelaxedTask::Dominance::drop)) {}

FFEvaluator::FFEvaluator(const FiniteDomainTask& task, std::shared_ptr<const RelaxedTask> relaxed)
    : exploration_(std::move(relaxed)), plan_(task, exploration_.task()) {}

Estimate FFEvaluator::evaluate(StateView state) {
    preferred_ = {};
    relaxed_plan_ = {};
    if (exploration_.run(state) == kDeadEnd) return kDeadEnd;
    const Estimate estimate = plan_.extract(exploration_, state);
    relaxed_plan_ = plan_.operators();
    if (preferred_wanted_) preferred_ = plan_.preferred();
    return estimate;
}

}  // namespace praxis
