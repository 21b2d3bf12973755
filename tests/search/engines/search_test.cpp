// The engines on random tasks against brute force, and their statuses and limits.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "search/engines/search.hpp"
#include "tests/search/engines/run.hpp"

namespace praxis {
namespace {

using test::add_operator;
using test::add_variable;
using test::arbitrary_options;
using test::arbitrary_task;
using test::endless_task;
using test::random_task;
using test::RandomTaskOptions;
using test::run;

TEST(Astar, IsOptimal) {
    for (const char* expression :
         {"astar(blind())", "astar(lmcut())", "astar(hmax())", "astar(max([hmax(),lmcut()]))",
          "eager(tiebreaking([sum([g(),lmcut()]),lmcut()],unsafe_pruning=false),reopen_closed=true)"}) {
        EXPECT_TRUE(rc::check(expression, [=] {
            const FiniteDomainTask task = arbitrary_task();
            const std::int64_t best = test::cheapest_plan_cost(task);
            const Outcome outcome = run(task, expression);
            if (best < 0) {
                RC_ASSERT(outcome.status == Status::unsolvable);
                RC_ASSERT(!outcome.plan.has_value());
            } else {
                RC_ASSERT(outcome.status == Status::solved);
                RC_ASSERT(test::execute(task, *outcome.plan) == best);
                RC_ASSERT(outcome.cost == best);
                RC_ASSERT(outcome.optimal == std::string(expression).starts_with("astar"));
            }
        }));
    }
}

TEST(Astar, ClaimsOptimalityOnlyForAdmissibleHeuristics) {
    FiniteDomainTask task;
    add_variable(task, 2, 0);
    add_operator(task, {{0, 0}}, {{{0, 1}, {}}}, 0);
    task.goal = {{0, 1}};
    EXPECT_TRUE(run(task, "astar(lmcut())").optimal);
    EXPECT_FALSE(run(task, "astar(lmcut(cost_type=one))").optimal);
    EXPECT_FALSE(run(task, "astar(lmcut(),cost_type=one)").optimal);
    EXPECT_FALSE(run(task, "astar(ff())").optimal);
    EXPECT_FALSE(run(task, "astar(weight(blind(),2))").optimal);
}

TEST(Engines, FindPlansExactlyWhereThereAreSome) {
    for (const char* expression :
         {"lazy_greedy([ff()],preferred=[ff()])",
          "lazy_greedy([ff(),goalcount()],preferred=[ff(),add()],boost=100)",
          "lazy_greedy([goalcount()],randomize_successors=true)",
          "lazy_greedy([blind()],preferred=[ff()],preferred_successors_first=true)",
          "lazy_wastar([ff(cost_type=one),hmax()],preferred=[ff(cost_type=one)],w=3,cost_type=plusone)",
          "lazy(tiebreaking([goalcount(),g()]),reopen_closed=true)",
          "eager_greedy([ff()],preferred=[ff()],boost=10)",
          "eager_greedy([goalcount(),add()])",
          "eager_wastar([add()],w=2)",
          "eager_wastar([goalcount()],w=2,cost_type=one)",
          "eager(alt([single(ff()),type_based([g(),goalcount()])]))",
          "eager(single(g()))",
          "lazy_greedy([landmark_sum(),ff()],preferred=[ff(),landmark_sum()])",
          "eager_greedy([landmark_sum(cost_type=plusone)],preferred=[landmark_sum(cost_type=plusone)])",
          "lazy(tiebreaking([novelty([goalcount()]),goalcount()]))",
          "lazy(alt([single(ff()),single(novelty([ff(),g()],width=1,forget=true))]),preferred=[ff()])",
          "eager(tiebreaking([novelty([],memory=1),ff()]))",
          "h2(lazy_greedy([ff()],preferred=[ff()]))",
          "iterated([h2(lazy_greedy([goalcount()]),seconds=1),lazy_greedy([ff()])],first=true)",
          "eager(tiebreaking([novelty([goalcount(),relaxed_counter()]),goalcount()]))",
          "eager(tiebreaking([novelty([relaxed_counter()],width=1,sample=2),goalcount()]))",
          "portfolio([lazy_greedy([ff()],preferred=[ff()]),eager(single(goalcount()))],first=true)"}) {
        EXPECT_TRUE(rc::check(expression, [=] {
            const FiniteDomainTask task = arbitrary_task();
            const std::int64_t best = test::cheapest_plan_cost(task);
            const Outcome outcome = run(task, expression);
            if (best < 0) {
                RC_ASSERT(outcome.status == Status::unsolvable || outcome.status == Status::failed);
            } else {
                RC_ASSERT(outcome.status == Status::solved);
                RC_ASSERT(!outcome.optimal);
                const std::int64_t cost = test::execute(task, *outcome.plan);
                RC_ASSERT(cost >= best);
                RC_ASSERT(outcome.cost == cost);
            }
        }));
    }
}

TEST(Iterated, EndsWithACheapestPlan) {
    for (const char* expression :
         {"iterated([lazy_greedy([ff(cost_type=one)],cost_type=one),lazy_wastar([ff()],w=3),lazy_wastar([ff()"
          "])])",
          "iterated([eager_greedy([goalcount()]),astar(blind())],improve=false)",
          "lazy_wastar([ff()],w=3,go_on=true)", "lazy_wastar([goalcount()],preferred=[ff()],go_on=true)",
          "h2(iterated([lazy_greedy([landmark_sum()]),eager_wastar([landmark_sum()],w=1)]))"}) {
        EXPECT_TRUE(rc::check(expression, [=] {
            const FiniteDomainTask task = arbitrary_task();
            const std::int64_t best = test::cheapest_plan_cost(task);
            std::vector<std::int64_t> costs;
            SearchCallbacks callbacks;
            callbacks.on_plan = [&](std::span<const OperatorId> plan, std::int64_t cost) {
                RC_ASSERT(test::execute(task, {plan.begin(), plan.end()}) == cost);
                costs.push_back(cost);
            };
            const Outcome outcome = run(task, expression, {}, callbacks);
            if (best < 0) {
                RC_ASSERT(outcome.status == Status::unsolvable || outcome.status == Status::failed);
                RC_ASSERT(costs.empty());
            } else {
                RC_ASSERT(outcome.status == Status::solved);
                RC_ASSERT(outcome.optimal || best == 0);
                RC_ASSERT(outcome.cost == best);
                RC_ASSERT(costs.back() == best);
                RC_ASSERT(std::is_sorted(costs.rbegin(), costs.rend()));
                RC_ASSERT(std::adjacent_find(costs.begin(), costs.end()) == costs.end());
            }
        }));
    }
}

TEST(Iterated, ClaimsOptimalityOnlyWithAProof) {
    // A dear way in one step, a cheap one in two.
    FiniteDomainTask task;
    add_variable(task, 3, 0);
    add_operator(task, {{0, 0}}, {{{0, 2}, {}}}, 9);
    add_operator(task, {{0, 0}}, {{{0, 1}, {}}}, 2);
    add_operator(task, {{0, 1}}, {{{0, 2}, {}}}, 2);
    task.goal = {{0, 2}};
    const std::string dear = "iterated([lazy_greedy([ff(cost_type=one)],cost_type=one),";
    const Outcome bounded = run(task, dear + "astar(blind(),bound=3)],improve=false,repeat_last=false)");
    EXPECT_EQ(bounded.cost, 9);
    EXPECT_FALSE(bounded.optimal);
    EXPECT_FALSE(run(task, dear + "lazy_greedy([ff(cost_type=one)],cost_type=one)],improve=false)").optimal);
    const Outcome proved = run(task, dear + "lazy_wastar([ff()],w=5)],improve=false)");
    EXPECT_EQ(proved.cost, 4);
    EXPECT_TRUE(proved.optimal);
    EXPECT_EQ(run(task, dear + "lazy_greedy([ff(cost_type=one)],cost_type=one)])").cost, 4) << "improved";
}

TEST(Engines, KeepTheBound) {
    for (const char* engine : {"astar(blind(),bound=",
                               "lazy_greedy([ff()],preferred=[ff()],reopen_closed=true,cost_type=one,bound=",
                               "eager_wastar([goalcount()],cost_type=plusone,bound="}) {
        EXPECT_TRUE(rc::check(engine, [=] {
            RandomTaskOptions options = arbitrary_options();
            options.largest_cost = *rc::gen::element(1, 5, 100000);
            options.variables = 6;
            options.operators = 25;
            std::int64_t best = 0;
            FiniteDomainTask task;
            for (auto seed = *rc::gen::arbitrary<std::uint32_t>(); best <= 0; ++seed) {
                task = random_task(seed, options);
                best = test::cheapest_plan_cost(task);
            }
            const std::string expression = engine + std::to_string(best);
            RC_ASSERT(run(task, expression + ")").status == Status::failed);
            const Outcome outcome = run(task, engine + std::to_string(best + 1) + ")");
            if (std::string(engine).starts_with("astar")) RC_ASSERT(outcome.status == Status::solved);
            if (outcome.plan) RC_ASSERT(test::execute(task, *outcome.plan) == best);
        }));
    }
}

TEST(Engines, AreDeterministic) {
    EXPECT_TRUE(rc::check([] {
        const FiniteDomainTask task = arbitrary_task();
        const auto seed = *rc::gen::arbitrary<std::uint64_t>();
        for (const char* expression : {"lazy_greedy([ff()],preferred=[ff()],randomize_successors=true)",
                                       "eager(type_based([g()]))", "astar(lmcut())",
                                       "portfolio([eager(type_based([g()])),lazy_greedy([ff()])],first=true,"
                                       "turn=0.00001)"}) {
            const Outcome first = run(task, expression, {}, {}, seed);
            const Outcome second = run(task, expression, {}, {}, seed);
            RC_ASSERT(first.plan == second.plan);
            RC_ASSERT(first.statistics.generated == second.statistics.generated);
        }
    }));
}

TEST(Search, KnowsTrivialPlans) {
    FiniteDomainTask task;
    add_variable(task, 2, 1);
    for (const char* expression : {"astar(lmcut())", "lazy_greedy([ff()])", "eager_greedy([goalcount()])"}) {
        Outcome outcome = run(task, expression);
        ASSERT_EQ(outcome.status, Status::solved) << "empty goal";
        EXPECT_TRUE(outcome.plan->empty());
        FiniteDomainTask with_goal = task;
        with_goal.goal = {{0, 1}};
        outcome = run(with_goal, expression);
        ASSERT_EQ(outcome.status, Status::solved);
        EXPECT_TRUE(outcome.plan->empty());
        with_goal.goal = {{0, 0}};
        EXPECT_EQ(run(with_goal, expression).status, Status::unsolvable) << expression;
    }
}

TEST(Search, AnswersOtherQueries) {
    FiniteDomainTask task;
    add_variable(task, 4, 0);
    for (std::int32_t i = 0; i < 3; ++i) add_operator(task, {{0, i}}, {{{0, i + 1}, {}}});
    task.goal = {{0, 3}};
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(std::move(task)));
    const Configuration config = configuration("lazy_greedy([ff()])");
    EXPECT_EQ(search(prepared, {{0}, {{0, 3}}}, config).cost, 3);
    EXPECT_EQ(search(prepared, {{1}, {{0, 2}}}, config).cost, 1);
    EXPECT_EQ(search(prepared, {{2}, {{0, 1}}}, config).status, Status::unsolvable);
    EXPECT_THROW(search(prepared, {{}, {}}, config), std::invalid_argument);
    EXPECT_THROW(search(prepared, {{4}, {}}, config), std::invalid_argument);
    EXPECT_THROW(search(prepared, {{0}, {{1, 0}}}, config), std::invalid_argument);
    EXPECT_THROW(search(prepared, {{0}, {{-1, 0}}}, config), std::invalid_argument);
}

TEST(Search, BelievesTheGrounder) {
    FiniteDomainTask task = endless_task(3);
    task.proved_unsolvable = true;
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(task));
    const Configuration config = configuration("astar(blind())");
    Query query = task_query(task);
    EXPECT_EQ(search(prepared, query, config).status, Status::unsolvable_early);
    query.goal = {{0, 1}};
    EXPECT_EQ(search(prepared, query, config).status, Status::solved);
}

TEST(Search, AddsUpLargeCosts) {
    FiniteDomainTask task;
    add_variable(task, 11, 0);
    for (std::int32_t i = 0; i < 10; ++i) add_operator(task, {{0, i}}, {{{0, i + 1}, {}}}, 2'000'000'000);
    task.goal = {{0, 10}};
    for (const char* expression : {"astar(blind())", "lazy_wastar([goalcount()],w=1000000000)",
                                   "lazy_greedy([goalcount()],cost_type=one,bound=20000000001)"}) {
        const Outcome outcome = run(task, expression);
        EXPECT_EQ(outcome.status, Status::solved) << expression;
        EXPECT_EQ(outcome.cost, 20'000'000'000) << expression;
    }
}

TEST(Search, CountsWhatItDoes) {
    FiniteDomainTask task = endless_task(10);
    const Outcome outcome = run(task, "astar(const(0))");
    EXPECT_EQ(outcome.status, Status::unsolvable);
    EXPECT_EQ(outcome.statistics.registered_states, 1024u);
    EXPECT_EQ(outcome.statistics.expanded, 1024u);
    EXPECT_EQ(outcome.statistics.generated, 10240u);
    EXPECT_GT(outcome.statistics.bytes_per_state, 12);
    EXPECT_LT(outcome.statistics.bytes_per_state, 30);
    EXPECT_GT(outcome.statistics.peak_memory, 1u << 20);
}

class Limits : public testing::TestWithParam<const char*> {};

TEST_P(Limits, EndInTime) {
    const auto start = Budget::Clock::now();
    const Outcome outcome = run(endless_task(28), GetParam(), Budget().limit_wall_time(0.3));
    const double seconds = std::chrono::duration<double>(Budget::Clock::now() - start).count();
    EXPECT_EQ(outcome.status, Status::out_of_time);
    EXPECT_GT(outcome.statistics.expanded, 0u);
    EXPECT_GT(outcome.statistics.seconds, 0.2);
    EXPECT_LT(seconds, 0.6);
}

TEST_P(Limits, EndInMemory) {
    const Outcome outcome = run(endless_task(300), GetParam(),
                                Budget().limit_memory(resident_memory() + (std::size_t{20} << 20)));
    EXPECT_EQ(outcome.status, Status::out_of_memory);
    EXPECT_GT(outcome.statistics.registered_states, 1000u);
}

TEST_P(Limits, EndWhenInterrupted) {
    std::stop_source source;
    std::jthread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        source.request_stop();
    });
    const auto start = Budget::Clock::now();
    EXPECT_EQ(run(endless_task(28), GetParam(), Budget().stop_with(source.get_token())).status,
              Status::interrupted);
    EXPECT_LT(std::chrono::duration<double>(Budget::Clock::now() - start).count(), 0.4);
}

TEST_P(Limits, ReportProgress) {
    int reports = 0;
    std::uint64_t expanded = 0;
    SearchCallbacks callbacks;
    callbacks.on_progress = [&](const SearchStatistics& statistics) {
        ++reports;
        EXPECT_GT(statistics.expanded, expanded);
        expanded = statistics.expanded;
        EXPECT_GT(statistics.registered_states, 0u);
        EXPECT_TRUE(statistics.best_estimate.has_value());
    };
    run(endless_task(28), GetParam(), Budget().limit_wall_time(0.9), callbacks);
    EXPECT_GE(reports, 2);
    EXPECT_LE(reports, 4);
}

INSTANTIATE_TEST_SUITE_P(Engines, Limits,
                         testing::Values("astar(blind())",
                                         "lazy_wastar([goalcount()],randomize_successors=true)",
                                         "eager(alt([single(goalcount()),type_based([g()])]))",
                                         "portfolio([astar(blind()),eager(single(goalcount()))])"));

TEST(Search, EndsWhenItsOwnTimeIsOver) {
    EXPECT_EQ(run(endless_task(28), "astar(blind(),max_time=0.1)").status, Status::out_of_time);
    const Outcome once = run(endless_task(28), "astar(blind(),max_work=0.01)");
    EXPECT_EQ(once.status, Status::out_of_time);
    EXPECT_EQ(once.statistics.expanded, run(endless_task(28), "astar(blind(),max_work=0.01)").statistics.expanded);
}

std::size_t virtual_memory() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(Search, SurvivesFailedAllocations) {
#ifdef PRAXIS_SANITIZED
    GTEST_SKIP() << "sanitizers do not let allocations fail";
#endif
    EXPECT_EXIT(
        {
            rlimit limit{};
            limit.rlim_cur = limit.rlim_max = virtual_memory() + (std::size_t{64} << 20);
            setrlimit(RLIMIT_AS, &limit);
            const Outcome outcome = run(endless_task(300), "astar(blind())");
            std::exit(outcome.status == Status::out_of_memory &&
                              outcome.statistics.registered_states > 1000000
                          ? 22
                          : 1);
        },
        testing::ExitedWithCode(22), "");
}

TEST(Search, SaysWhenThePreparationWasCutShort) {
    std::stop_source source;
    source.request_stop();
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(endless_task(3)),
                                Budget().stop_with(source.get_token()));
    EXPECT_EQ(prepared.stop(), Stop::interrupted);
    EXPECT_EQ(search(prepared, task_query(prepared.task()), configuration("astar(blind())")).status,
              Status::interrupted);
}

TEST(Search, HandsOverThePlan) {
    FiniteDomainTask task = endless_task(2);
    task.goal = {{0, 1}, {1, 1}};
    int plans = 0;
    SearchCallbacks callbacks;
    callbacks.on_plan = [&](std::span<const OperatorId> plan, std::int64_t cost) {
        ++plans;
        EXPECT_EQ(cost, 2);
        EXPECT_EQ(test::execute(task, plan), 2);
    };
    run(task, "astar(lmcut())", {}, callbacks);
    EXPECT_EQ(plans, 1);
}

TEST(Search, RunsOnSeveralThreadsAtOnce) {
    const FiniteDomainTask task = endless_task(12);
    const PreparedTask prepared(std::make_shared<FiniteDomainTask>(task));
    std::vector<Outcome> outcomes(4);
    {
        std::vector<std::jthread> threads;
        for (Outcome& outcome : outcomes) {
            threads.emplace_back([&] {
                outcome = search(prepared, task_query(task), configuration("lazy_greedy([goalcount()])"));
            });
        }
    }
    for (const Outcome& outcome : outcomes) {
        EXPECT_EQ(outcome.status, Status::unsolvable);
        EXPECT_EQ(outcome.statistics.expanded, outcomes[0].statistics.expanded);
    }
}

}  // namespace
}  // namespace praxis
