#include "belief/offline/optimal_policy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "belief/offline/check_conditional_plan.hpp"
#include "belief/offline/omniscient.hpp"
#include "naive_optimum.hpp"
#include "support.hpp"

namespace praxis::belief {
namespace {

using Criterion = OptimalPolicyOptions::Criterion;

/// Sum over the worlds, or cost of the worst, in the ground task's units.
std::int64_t total(const BeliefTask& task, const OptimalPolicy& policy, bool worst) {
    double result = 0;
    for (double cost : policy.costs.costs) result = worst ? std::max(result, cost) : result + cost;
    return std::llround(result * static_cast<double>(task.physical->cost_scale));
}

void compare(bool worst) {
    int solvable = 0, unsolvable = 0, branching = 0;
    for (std::uint64_t seed = 0; seed < 1500; ++seed) {
        const testing::Texts texts = testing::random_task(seed);
        SCOPED_TRACE(std::to_string(seed) + "\n" + texts.domain + "\n" + texts.problem);
        const auto task = testing::ground_random(texts);
        if (!task) continue;
        const auto naive = testing::naive_optimum(task, worst, 300);
        if (!naive) continue;
        OptimalPolicyOptions options;
        options.criterion = worst ? Criterion::worst_cost : Criterion::expected_cost;
        const OptimalPolicy policy = optimal_policy(task, options);
        if (!naive->cost) {
            ASSERT_EQ(policy.status, OptimalPolicy::Status::unsolvable);
            ++unsolvable;
            continue;
        }
        ASSERT_EQ(policy.status, OptimalPolicy::Status::optimal) << policy.message;
        ASSERT_EQ(total(*task, policy, worst), *naive->cost);
        const ConditionalVerdict verdict = check_conditional_plan(task, policy.plan, policy.worlds);
        ASSERT_TRUE(verdict.valid) << verdict.reason;
        ASSERT_EQ(verdict.checked, policy.worlds.size());
        ++solvable;
        branching += policy.plan.edge_count() >= policy.plan.size();
    }
    EXPECT_GE(solvable, 200);
    EXPECT_GE(unsolvable, 50);
    EXPECT_GE(branching, 20);
}

TEST(OptimalPolicy, CostsOnAverageWhatBruteForceFinds) {
    compare(false);
}

TEST(OptimalPolicy, CostsAtWorstWhatBruteForceFinds) {
    compare(true);
}

TEST(OptimalPolicy, NobodyIsCheaperThanOneWhoKnows) {
    const auto task = testing::ground(testing::corridor(2));
    const OptimalPolicy policy = optimal_policy(task);
    ASSERT_EQ(policy.status, OptimalPolicy::Status::optimal);
    ASSERT_EQ(policy.worlds.size(), 9u);
    const Omniscient omniscient(task);
    double mean = 0;
    for (std::size_t world = 0; world < policy.worlds.size(); ++world) {
        const Omniscient::Cost known = omniscient.cost(policy.worlds[world]);
        ASSERT_EQ(known.status, Omniscient::Status::optimal);
        EXPECT_EQ(known.cost, policy.omniscient[world]);
        EXPECT_LE(known.cost, policy.costs.costs[world]);
        mean += policy.costs.costs[world] / 9;
    }
    EXPECT_NEAR(mean, policy.costs.mean, 1e-9);
    EXPECT_GT(policy.costs.mean, 4);  // the shortest way, without a look
}

TEST(OptimalPolicy, TheWorstCostIsAtMostThatOfTheBestMean) {
    const auto task = testing::ground(testing::corridor(3));
    OptimalPolicyOptions worst;
    worst.criterion = Criterion::worst_cost;
    const OptimalPolicy on_average = optimal_policy(task);
    const OptimalPolicy at_worst = optimal_policy(task, worst);
    ASSERT_EQ(at_worst.status, OptimalPolicy::Status::optimal);
    EXPECT_LE(at_worst.costs.worst, on_average.costs.worst);
    EXPECT_GE(at_worst.costs.mean, on_average.costs.mean);
}

TEST(OptimalPolicy, KeepsItsLimits) {
    const auto task = testing::ground(testing::corridor(3));
    OptimalPolicyOptions options;
    options.most_worlds = 26;
    EXPECT_EQ(optimal_policy(task, options).message, "too many first states");
    options = {};
    options.most_states = 10;
    EXPECT_EQ(optimal_policy(task, options).message, "too many states");
    options = {};
    options.most_beliefs = 10;
    EXPECT_EQ(optimal_policy(task, options).status, OptimalPolicy::Status::not_computed);
    const OptimalPolicy late = optimal_policy(task, {}, Budget().limit_wall_time(0));
    EXPECT_EQ(late.status, OptimalPolicy::Status::not_computed);
}

TEST(OptimalPolicy, RefusesReadingsWithErrors) {
    testing::Texts texts = testing::corridor(1);
    const std::string clean = ":observe (open ?q)";
    texts.domain.replace(texts.domain.find(clean), clean.size(), ":observe (probabilistic 0.9 (open ?q))");
    const OptimalPolicy policy = optimal_policy(testing::ground(texts));
    EXPECT_EQ(policy.status, OptimalPolicy::Status::not_computed);
    EXPECT_NE(policy.message.find("errors"), std::string::npos);
}

TEST(Omniscient, SeesThatThereIsNoPlan) {
    const auto task = testing::ground(testing::corridor(1));
    // No door is open at all: not what the description allows, but a state.
    WorldState world = task->initial_values;
    for (std::size_t v = 0; v < world.size(); ++v) {
        if (world[v] != BeliefTask::kUnknown) continue;
        world[v] = task->physical->is_atom({static_cast<std::int32_t>(v), 0}) ? 1 : 0;
    }
    EXPECT_EQ(Omniscient(task).cost(world).status, Omniscient::Status::unsolvable);
}

}  // namespace
}  // namespace praxis::belief
