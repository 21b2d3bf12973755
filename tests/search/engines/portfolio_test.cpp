// Engines side by side: turns, shared bounds, proofs, repeatable runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "search/engines/turns.hpp"
#include "tests/search/engines/run.hpp"

namespace praxis {
namespace {

using test::endless_task;
using test::run;

TEST(Turns, GoRoundOneAtATime) {
    Turns turns(3, 1);
    std::vector<std::size_t> order;
    {
        std::vector<std::jthread> threads;
        for (const std::size_t engine : {std::size_t{0}, std::size_t{1}, std::size_t{2}}) {
            threads.emplace_back([&turns, &order, engine] {
                turns.enter(engine);
                for (std::size_t turn = 0; turn <= engine; ++turn) {
                    order.push_back(engine);
                    turns.pass(engine);
                }
                turns.leave(engine);
            });
        }
    }
    EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 1, 2, 2}));
}

TEST(Turns, AreNeverMoreThanAllowed) {
    constexpr std::size_t kEngines = 6;
    Turns turns(kEngines, 2);
    std::atomic<int> running{0};
    std::atomic<int> most{0};
    {
        std::vector<std::jthread> threads;
        for (std::size_t engine = 0; engine < kEngines; ++engine) {
            threads.emplace_back([&, engine] {
                turns.enter(engine);
                for (int turn = 0; turn < 200; ++turn) {
                    const int now = ++running;
                    for (int before = most; now > before && !most.compare_exchange_weak(before, now);) {
                    }
                    --running;
                    turns.pass(engine);
                }
                turns.leave(engine);
            });
        }
    }
    EXPECT_LE(most, 2);
    EXPECT_GE(most, 1);
}

TEST(Turns, GoOnWithoutAnEngineThatNeverBegins) {
    Turns turns(2, 1);
    turns.leave(1);
    turns.enter(0);
    turns.pass(0);
    turns.leave(0);
}

TEST(Turns, BecomeLonger) {
    Turns turns(1, 1);
    Seat seat(turns, 0, 10);
    turns.enter(0);
    std::vector<std::uint64_t> work;
    for (int turn = 0; turn < 6; ++turn) {
        work.push_back(seat.work());
        seat.pass();
    }
    EXPECT_EQ(work, (std::vector<std::uint64_t>{10, 20, 40, 80, 80, 80}));
}

TEST(Portfolio, EndsWithACheapestPlan) {
    for (const char* expression :
         {"portfolio([astar(blind()),lazy_greedy([ff()])],turn=0.00001)",
          "portfolio([lazy_greedy([goalcount()],cost_type=one),iterated([eager_greedy([ff()]),"
          "lazy_wastar([ff()],w=1)]),h2(lazy_greedy([ff()]))],turn=0.00001)",
          "iterated([portfolio([lazy_greedy([ff()]),lazy_greedy([goalcount()])],first=true),"
          "astar(blind())])",
          "iterated([lazy_greedy([ff(cost_type=one)],cost_type=one),"
          "portfolio([polish(first=10,states=1000),lazy_wastar([ff()],w=3,go_on=true)],turn=0.00001)])"}) {
        for (const int threads : {1, 2, 5}) {
            EXPECT_TRUE(rc::check(expression, [=] {
                const FiniteDomainTask task = test::arbitrary_task();
                const std::int64_t best = test::cheapest_plan_cost(task);
                std::vector<std::int64_t> costs;
                SearchCallbacks callbacks;
                callbacks.on_plan = [&](std::span<const OperatorId> plan, std::int64_t cost) {
                    if (test::execute(task, {plan.begin(), plan.end()}) != cost) std::abort();
                    costs.push_back(cost);
                };
                const Outcome outcome = run(task, expression, {}, callbacks, 0, threads);
                if (best < 0) {
                    RC_ASSERT(outcome.status == Status::unsolvable || outcome.status == Status::failed);
                    RC_ASSERT(costs.empty());
                    return;
                }
                RC_ASSERT(outcome.status == Status::solved);
                RC_ASSERT(outcome.cost == best);
                RC_ASSERT(outcome.optimal || best == 0);
                RC_ASSERT(test::execute(task, *outcome.plan) == best);
                RC_ASSERT(costs.back() == best);
                RC_ASSERT(std::is_sorted(costs.rbegin(), costs.rend()));
                RC_ASSERT(std::adjacent_find(costs.begin(), costs.end()) == costs.end());
            }));
        }
    }
}

TEST(Portfolio, DoesTheSameEveryTimeOnOneThread) {
    EXPECT_TRUE(rc::check([] {
        const FiniteDomainTask task = test::arbitrary_task();
        const char* expression =
            "portfolio([lazy_greedy([ff()]),eager(type_based([g()])),lazy_wastar([goalcount()])],turn=0."
            "00001)";
        const Outcome first = run(task, expression);
        const Outcome second = run(task, expression);
        RC_ASSERT(first.plan == second.plan);
        RC_ASSERT(first.status == second.status);
        RC_ASSERT(first.statistics.generated == second.statistics.generated);
        RC_ASSERT(first.statistics.evaluated == second.statistics.evaluated);
    }));
}

TEST(Polish, MakesThePlanFoundBeforeCheaper) {
    // A dear way in one step, a cheap one in two.
    FiniteDomainTask task;
    test::add_variable(task, 3, 0);
    test::add_operator(task, {{0, 0}}, {{{0, 2}, {}}}, 9);
    test::add_operator(task, {{0, 0}}, {{{0, 1}, {}}}, 2);
    test::add_operator(task, {{0, 1}}, {{{0, 2}, {}}}, 2);
    task.goal = {{0, 2}};
    const Outcome outcome =
        run(task, "iterated([lazy_greedy([ff(cost_type=one)],cost_type=one),polish()],improve=false)");
    EXPECT_EQ(outcome.status, Status::solved);
    EXPECT_EQ(outcome.cost, 4);
    EXPECT_EQ(run(task, "polish()").status, Status::failed) << "there is no plan to improve";
}

TEST(Portfolio, ThePlanOfOneStopsTheOthers) {
    // The first would have to look at 2^28 states.
    for (const int threads : {1, 2}) {
        FiniteDomainTask task = endless_task(28);
        task.goal.clear();
        for (std::int32_t v = 0; v < 28; ++v) task.goal.push_back({v, 1});
        const Outcome outcome =
            run(task, "portfolio([astar(blind()),lazy_greedy([ff()])],first=true,turn=0.01)",
                Budget().limit_wall_time(20), {}, 0, threads);
        EXPECT_EQ(outcome.status, Status::solved);
        EXPECT_LT(outcome.statistics.seconds, 10);
        EXPECT_FALSE(outcome.optimal);
    }
}

}  // namespace
}  // namespace praxis
