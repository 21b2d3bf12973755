// Plans of random walks, made better, against brute force.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <optional>
#include <random>
#include <stdexcept>

#include "search/improve/action_elimination.hpp"
#include "search/improve/improve_plan.hpp"
#include "search/improve/neighbourhood.hpp"
#include "search/improve/plan_execution.hpp"
#include "search/improve/windows.hpp"
#include "tests/search/state/random_task.hpp"

namespace praxis {
namespace {

using Plan = std::vector<OperatorId>;

struct Walk {
    FiniteDomainTask task;
    Plan plan;
};

/// A random walk of at most `longest` steps, and some facts of its last state as the goal.
Walk random_walk(std::uint64_t seed, const test::RandomTaskOptions& options, int longest) {
    Walk walk{test::random_task(seed, options), {}};
    std::mt19937_64 random(seed);
    test::Values values = test::initial_state(walk.task);
    for (int i = 0; i < longest; ++i) {
        const Plan operators = test::applicable(walk.task, values);
        if (operators.empty()) break;
        walk.plan.push_back(operators[random() % operators.size()]);
        values = test::successor(walk.task, values, walk.plan.back());
    }
    walk.task.goal.clear();
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (random() % 3 != 0) walk.task.goal.push_back({static_cast<std::int32_t>(i), values[i]});
    }
    return walk;
}

/// One of just that length, if that can be had.
Walk arbitrary_walk(int longest) {
    test::RandomTaskOptions options;
    options.variables = *rc::gen::element(1, 3, 5);
    options.derived = *rc::gen::element(0, 0, 2, 4);
    options.operators = *rc::gen::element(4, 10, 20);
    options.largest_cost = *rc::gen::element(1, 3, 1000000000);
    options.conditional_effects = *rc::gen::arbitrary<bool>();
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t attempt = 0;; ++attempt) {
        Walk walk = random_walk(seed + attempt, options, longest);
        // Many random tasks leave nothing to do after a few steps.
        if (static_cast<int>(walk.plan.size()) == longest || attempt == 20) return walk;
    }
}

PreparedTask prepare(const FiniteDomainTask& task) {
    return PreparedTask(std::make_shared<FiniteDomainTask>(task));
}

/// Cost and steps of a plan of the task; nothing if it is none.
std::optional<PlanCost> evaluate(const FiniteDomainTask& task, const Plan& plan) {
    const std::int64_t cost = test::execute(task, plan);
    if (cost < 0) return std::nullopt;
    return PlanCost{cost, static_cast<std::int64_t>(plan.size())};
}

PlanCost best_subsequence(const Walk& walk) {
    PlanCost best = *evaluate(walk.task, walk.plan);
    for (std::uint32_t kept = 0; kept < (1u << walk.plan.size()); ++kept) {
        Plan plan;
        for (std::size_t i = 0; i < walk.plan.size(); ++i) {
            if ((kept >> i) & 1u) plan.push_back(walk.plan[i]);
        }
        if (const auto cost = evaluate(walk.task, plan)) best = std::min(best, *cost);
    }
    return best;
}

bool subsequence(const Plan& part, const Plan& whole) {
    std::size_t i = 0;
    for (OperatorId op : whole) {
        if (i < part.size() && part[i] == op) ++i;
    }
    return i == part.size();
}

/// Checks that the plan is one and not worse than the walk.
Plan no_worse(const Walk& walk, const Plan& plan) {
    const auto cost = evaluate(walk.task, plan);
    RC_ASSERT(cost.has_value());
    RC_ASSERT(*cost <= *evaluate(walk.task, walk.plan));
    return plan;
}

TEST(ActionElimination, FindsTheBestSubsequence) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(*rc::gen::element(3, 8, 11));
        const PreparedTask prepared = prepare(walk.task);
        const Elimination result = eliminate_actions(prepared, task_query(prepared.task()), walk.plan, {});
        RC_ASSERT(result.optimal);
        RC_ASSERT(subsequence(result.plan, walk.plan));
        RC_ASSERT(evaluate(walk.task, result.plan) == best_subsequence(walk));
    }));
}

TEST(ActionElimination, NeverHarmsWhateverTheLimits) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(40);
        const PreparedTask prepared = prepare(walk.task);
        const Query query = task_query(prepared.task());
        EliminationLimits limits;
        limits.max_nodes = *rc::gen::element<std::size_t>(0, 1, 10, 100, 100000);
        limits.max_steps = *rc::gen::element<std::size_t>(0, 100, 10000, 10000000);
        const Plan greedy = eliminate_actions_greedily(prepared, query, walk.plan, {}, limits);
        RC_ASSERT(subsequence(no_worse(walk, greedy), walk.plan));
        const Plan best = eliminate_actions(prepared, query, walk.plan, {}, limits).plan;
        RC_ASSERT(subsequence(no_worse(walk, best), walk.plan));
        RC_ASSERT(*evaluate(walk.task, best) <= *evaluate(walk.task, greedy));
    }));
}

TEST(ActionElimination, LeavesNoSingleStepToTheGreedyPart) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(40);
        const PreparedTask prepared = prepare(walk.task);
        const Plan greedy = eliminate_actions_greedily(prepared, task_query(prepared.task()), walk.plan, {});
        for (std::size_t i = 0; i < greedy.size(); ++i) {
            Plan without = greedy;
            without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
            RC_ASSERT(test::execute(walk.task, without) < 0);
        }
    }));
}

TEST(ActionElimination, SeesThroughWhatGreedWouldKeep) {
    // Two ways over the same variable: greed removes the dearer part first and must then keep the rest.
    FiniteDomainTask task;
    test::add_variable(task, 2, 0);
    test::add_variable(task, 2, 0);
    test::add_variable(task, 2, 0);
    const OperatorId a = test::add_operator(task, {}, {{{0, 1}, {}}}, 4);
    const OperatorId b = test::add_operator(task, {}, {{{1, 1}, {}}}, 4);
    const OperatorId both = test::add_operator(task, {}, {{{0, 1}, {}}, {{1, 1}, {}}}, 5);
    const OperatorId end = test::add_operator(task, {{0, 1}, {1, 1}}, {{{2, 1}, {}}}, 1);
    task.goal = {{2, 1}};
    const PreparedTask prepared = prepare(task);
    const Query query = task_query(task);
    EXPECT_EQ(test::execute(task, eliminate_actions_greedily(prepared, query, {a, b, both, end}, {})), 9);
    const Elimination best = eliminate_actions(prepared, query, {a, b, both, end}, {});
    EXPECT_EQ(best.plan, (Plan{both, end}));
    EXPECT_TRUE(best.optimal);
}

TEST(Neighbourhood, IsOptimalWhenComplete) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(30);
        const PreparedTask prepared = prepare(walk.task);
        const Query query = task_query(prepared.task());
        const Neighbourhood result = search_neighbourhood(prepared, query, walk.plan, {});
        RC_ASSERT(result.complete);
        RC_ASSERT(test::execute(walk.task, result.plan) == test::cheapest_plan_cost(walk.task));
    }));
}

TEST(Neighbourhood, NeverHarmsWhateverTheLimits) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(30);
        const PreparedTask prepared = prepare(walk.task);
        NeighbourhoodLimits limits;
        limits.max_states = *rc::gen::inRange<std::size_t>(0, 60);
        const Query query = task_query(prepared.task());
        no_worse(walk, search_neighbourhood(prepared, query, walk.plan, {}, limits).plan);
        limits.max_bytes = 0;
        no_worse(walk, search_neighbourhood(prepared, query, walk.plan, {}, limits).plan);
    }));
}

TEST(Windows, AreValidAndOptimalIfOneHoldsThePlan) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(*rc::gen::element(5, 30));
        const PreparedTask prepared = prepare(walk.task);
        const Query query = task_query(prepared.task());
        const auto states = *rc::gen::element<std::size_t>(1, 20, 100000);
        const Plan plan = improve_windows(prepared, query, walk.plan, {}, states);
        no_worse(walk, plan);
        const bool whole_state = walk.task.has_axioms() || walk.task.has_conditional_effects();
        if (states == 100000 && !whole_state) {
            RC_ASSERT(test::execute(walk.task, plan) == test::cheapest_plan_cost(walk.task));
        }
    }));
}

TEST(ImprovePlan, IsValidNeverDearerAndDeterministic) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(40);
        const PreparedTask prepared = prepare(walk.task);
        const Query query = task_query(prepared.task());
        ImproveOptions options;
        options.max_states = *rc::gen::element<std::size_t>(0, 1, 30, 200000);
        options.window_states = *rc::gen::element<std::size_t>(0, 10, 1000);
        const Plan plan = improve_plan(prepared, query, walk.plan, {}, options);
        no_worse(walk, plan);
        RC_ASSERT(improve_plan(prepared, query, walk.plan, {}, options) == plan);
        if (options.max_states == 200000) {
            RC_ASSERT(test::execute(walk.task, plan) == test::cheapest_plan_cost(walk.task));
        }
    }));
}

TEST(ImprovePlan, ReturnsThePlanIfTheBudgetIsSpent) {
    EXPECT_TRUE(rc::check([] {
        const Walk walk = arbitrary_walk(40);
        const PreparedTask prepared = prepare(walk.task);
        const Budget spent = Budget().within(0);
        RC_ASSERT(improve_plan(prepared, task_query(prepared.task()), walk.plan, spent) == walk.plan);
    }));
}

TEST(ImprovePlan, RefusesWhatIsNoPlan) {
    FiniteDomainTask task;
    test::add_variable(task, 2, 0);
    const OperatorId op = test::add_operator(task, {{0, 1}}, {{{0, 0}, {}}});
    const PreparedTask prepared = prepare(task);
    EXPECT_THROW(improve_plan(prepared, task_query(task), {op}, {}), std::invalid_argument);
    EXPECT_EQ(improve_plan(prepared, task_query(task), {}, {}), Plan{});
}

}  // namespace
}  // namespace praxis
