// Runs in random tasks: no action is ever illegal, what is claimed is so, and without uncertainty the agent
// is a complete planner.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <deque>
#include <set>

#include "belief/agent.hpp"
#include "belief/check_run.hpp"
#include "belief/simulated_world.hpp"
#include "parser/diagnostic.hpp"
#include "tests/belief/naive_belief.hpp"
#include "tests/belief/random_contingent.hpp"

namespace praxis::belief::test {
namespace {

using State = NaiveBelief::State;

std::uint64_t any_seed() {
    return *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
}

std::shared_ptr<const BeliefTask> ground_or_nothing(const Texts& texts) {
    RC_LOG() << texts.domain << "\n" << texts.problem << "\n";
    try {
        return ground(texts);
    } catch (const InputError&) {
        return nullptr;
    }
}

/// Some state in which the goal holds can be reached from one of the first states.
bool reachable(const BeliefTask& task, const NaiveBelief& naive) {
    std::set<State> seen;
    std::deque<State> open;
    for (State& state : naive.first_states())
        if (seen.insert(state).second) open.push_back(state);
    for (; !open.empty(); open.pop_front()) {
        if (naive.goal(open.front())) return true;
        for (std::uint32_t action = 0; action < task.operator_count(); ++action)
            if (naive.applicable(action, open.front()))
                for (State& next : naive.successors(action, open.front()))
                    if (seen.insert(next).second) open.push_back(next);
    }
    return false;
}

AgentOptions options() {
    AgentOptions result = default_agent_options();
    result.most_steps = 40;
    result.most_plans = 40;
    result.plan_seconds = 0.5;
    return result;
}

/// Runs the agent in a few of the task's worlds and checks each run. `failures`: their probability.
void check_runs(const Constructs& constructs, std::size_t most_cases, std::size_t slots,
                double failures = 0) {
    const std::uint64_t seed = any_seed();
    const auto task = ground_or_nothing(random_contingent(seed, constructs));
    if (!task) return;
    const auto worlds = enumerate_worlds(*task, 1000);
    RC_ASSERT(worlds.has_value());
    const auto compilation = std::make_shared<const Compilation>(task, CompilationOptions{most_cases, slots});
    const Agent agent(std::make_shared<const KnowledgePlanner>(compilation), options());
    const NaiveBelief naive(*task);
    const bool possible = reachable(*task, naive);
    Random random(seed);
    for (std::size_t i = 0; i < std::min<std::size_t>(2, worlds->size()); ++i) {
        const WorldState& first = (*worlds)[random.below(worlds->size())];
        Belief belief(compilation);
        SimulatedWorld world(task, first, 0, seed, failures);
        Budget budget;
        budget.limit_wall_time(10);
        const RunResult result = agent.run(belief, world, budget);
        RC_LOG() << to_string(result.status) << " " << result.message << "\n";
        for (std::uint32_t action : result.actions)
            RC_LOG() << task->physical->operator_name(OperatorId(action)) << "\n";
        RC_ASSERT(result.status != RunStatus::illegal);
        RC_ASSERT(result.status != RunStatus::contradiction);
        RC_ASSERT(result.status != RunStatus::out_of_memory);
        RC_ASSERT(result.actions.size() <= options().most_steps);
        RC_ASSERT(result.plans <= options().most_plans);
        RC_ASSERT(result.plans == result.plan_seconds.size());
        if (result.status == RunStatus::infeasible) RC_ASSERT(!possible);
        if (result.status == RunStatus::reached) {
            RC_ASSERT(possible);
            RC_ASSERT(world.goal_holds());
            RC_ASSERT(naive.goal(naive.of(world.state())));
            const Verdict verdict = check_run(*task, first, world.happened(), world.after_chance());
            RC_LOG() << verdict.reason << "\n";
            RC_ASSERT(verdict.valid);
        }
        if (failures == 0) RC_ASSERT(world.happened() == result.actions);
        if (!constructs.uncertain && failures == 0)
            RC_ASSERT((result.status == RunStatus::reached) == possible);
    }
}

RC_GTEST_PROP(AgentProperties, RunsAreAsTheySay, ()) {
    check_runs({}, 20'000, 16);
}

RC_GTEST_PROP(AgentProperties, RunsAreAsTheySayWithoutCases, ()) {
    check_runs({}, 0, 16);
}

RC_GTEST_PROP(AgentProperties, RunsAreAsTheySayWithFewSlots, ()) {
    check_runs({.forgetting = false}, 20'000, 2);
}

RC_GTEST_PROP(AgentProperties, WithoutUncertaintyTheGoalIsReachedIfItCanBe, ()) {
    check_runs({.uncertain = false}, 20'000, 16);
}

RC_GTEST_PROP(AgentProperties, RunsWithFailuresAreAsTheySay, ()) {
    check_runs({}, 20'000, 16, 0.3);
}

}  // namespace
}  // namespace praxis::belief::test
