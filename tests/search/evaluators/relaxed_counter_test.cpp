// The counter of best-first width search against its definition, on random walks.
#include "search/evaluators/relaxed_counter.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>

#include "tests/search/evaluators/random_task.hpp"

namespace praxis {
namespace {

bool holds(const test::State& state, Fact fact) {
    return state[static_cast<std::size_t>(fact.variable)] == fact.value;
}

/// What has been reached of the relaxed plan of the last state on the way with fewer open goals than before.
Estimate naive_counter(const FiniteDomainTask& task, const std::vector<test::State>& way) {
    const auto open_goals = [&](const test::State& state) {
        return std::ranges::count_if(task.goal, [&](Fact fact) { return !holds(state, fact); });
    };
    std::size_t root = 0;
    for (std::size_t i = 1; i < way.size(); ++i) {
        if (open_goals(way[i]) < open_goals(way[root])) root = i;
    }
    FFEvaluator ff(task, task.goal, CostType::one);
    if (ff.evaluate(way[root]) == kDeadEnd) return kDeadEnd;
    std::set<Fact> wanted;
    for (const OperatorId op : ff.relaxed_plan()) {
        for (const GroundEffect& effect : task.effects[op.index()]) {
            if (!holds(way[root], effect.fact)) wanted.insert(effect.fact);
        }
    }
    return static_cast<Estimate>(std::ranges::count_if(wanted, [&](Fact fact) {
        return std::any_of(way.begin() + static_cast<std::ptrdiff_t>(root), way.end(),
                           [&](const test::State& state) { return holds(state, fact); });
    }));
}

TEST(RelaxedCounter, IsAsDefined) {
    EXPECT_TRUE(rc::check([] {
        const FiniteDomainTask task = test::random_task();
        RelaxedCounterEvaluator counter(task, task.goal,
                                        std::make_shared<const RelaxedTask>(task, task.goal, CostType::one,
                                                                            RelaxedTask::Dominance::drop));
        std::vector<test::State> way{task.initial_values};
        counter.start(StateId(0), way.back());
        for (std::uint32_t step = 0;; ++step) {
            counter.at(StateId(step));
            RC_ASSERT(counter.evaluate(way.back()) == naive_counter(task, way));
            if (step == 20 || task.operator_count() == 0) break;
            const OperatorId op(
                static_cast<std::uint32_t>(test::pick(static_cast<std::int32_t>(task.operator_count()))));
            test::State next = way.back();
            for (const GroundEffect& effect : task.effects[op.index()])
                next[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
            // Another way to a known state changes nothing.
            counter.follow(StateId(0), op, StateId(step), next);
            counter.follow(StateId(step), op, StateId(step + 1), next);
            way.push_back(std::move(next));
        }
    }));
}

}  // namespace
}  // namespace praxis
