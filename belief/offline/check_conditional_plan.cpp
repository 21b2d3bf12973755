#include "belief/offline/check_conditional_plan.hpp"

#include <optional>
#include <vector>

#include "belief/check_run.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::belief {
namespace {

/// What fails in one world; empty if nothing does.
std::string run(const std::shared_ptr<const BeliefTask>& task, const ConditionalPlan& plan,
                const WorldState& first) {
    SimulatedWorld world(task, first);
    std::vector<std::uint32_t> actions;
    std::uint32_t node = 0;
    while (!plan.goal(node)) {
        const std::uint32_t action = plan.action(node);
        if (action != Environment::kStart) {
            const Execution execution = world.execute(action);
            if (execution.status != Execution::Status::done) return execution.message;
            actions.push_back(action);
        }
        std::vector<Fact> answers;
        for (const Answer& answer : world.observe(action)) answers.push_back(answer.fact);
        const std::optional<std::uint32_t> next = plan.next(node, answers);
        if (!next)
            return "nothing is planned for what is read after action " + std::to_string(actions.size());
        node = *next;
    }
    if (!world.goal_holds()) return "the goal does not hold at the end";
    const Verdict verdict = check_run(*task, first, actions);
    return verdict.valid ? "" : verdict.reason;
}

}  // namespace

ConditionalVerdict check_conditional_plan(const std::shared_ptr<const BeliefTask>& task,
                                          const ConditionalPlan& plan, std::span<const WorldState> worlds,
                                          const Budget& budget) {
    ConditionalVerdict verdict;
    if (plan.size() == 0) {
        verdict.reason = "there is no plan";
        return verdict;
    }
    for (const WorldState& world : worlds) {
        if (budget.exhausted() != Stop::none) return verdict;
        std::string failure = run(task, plan, world);
        ++verdict.checked;
        if (failure.empty()) continue;
        verdict.reason = "in world " + std::to_string(verdict.checked - 1) + ": " + failure;
        return verdict;
    }
    verdict.valid = verdict.checked > 0;
    return verdict;
}

}  // namespace praxis::belief
