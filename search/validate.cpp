#include "search/validate.hpp"

#include "search/validate/describe.hpp"
#include "search/validate/executor.hpp"

namespace praxis {

Verdict validate(const LiftedTask& task, const Plan& plan) {
    validation::Executor executor(task);
    Verdict verdict;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const PlanStep& step = plan.steps[i];
        const auto failure = executor.execute(step);
        if (!failure) continue;
        const std::string name =
            step.schema.index() < task.schemas.size() ? task.schemas[step.schema.index()].name : "?";
        verdict.step = i + 1;
        verdict.reason = "step " + std::to_string(i + 1) + " " +
                         validation::describe(name, step.arguments, task) + ": " + *failure;
        verdict.cost = executor.cost();
        return verdict;
    }
    verdict.cost = executor.cost();
    if (const auto failure = executor.goal_failure()) {
        verdict.step = plan.steps.size() + 1;
        verdict.reason = "the goal is not reached: " + *failure;
        return verdict;
    }
    verdict.valid = true;
    return verdict;
}

}  // namespace praxis
