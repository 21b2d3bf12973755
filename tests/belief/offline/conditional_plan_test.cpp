#include "belief/offline/conditional_plan.hpp"

#include <gtest/gtest.h>

#include "belief/offline/check_conditional_plan.hpp"
#include "belief/offline/conditional_planner.hpp"
#include "belief/offline/offline.hpp"
#include "belief/offline/offline_texts.hpp"
#include "belief/offline/optimal_policy.hpp"
#include "support.hpp"

namespace praxis::belief {
namespace {

KnowledgePlanner planner_for(const std::shared_ptr<const BeliefTask>& task) {
    return KnowledgePlanner(std::make_shared<const Compilation>(task));
}

using Reuse = ConditionalPlannerOptions::Reuse;

ConditionalPlannerOptions planner_options(Reuse reuse) {
    ConditionalPlannerOptions options;
    options.first = configuration("lazy_greedy([ff()],preferred=[ff()])");
    options.second = alias("agile");
    options.reuse = reuse;
    return options;
}

TEST(PlanDraft, AddsEqualNodesOnce) {
    PlanDraft draft;
    const std::uint32_t a = draft.add(7, {{{}, draft.goal()}});
    EXPECT_EQ(draft.add(7, {{{{0, 1}}, draft.goal()}}), a);  // one way to go on: the answer does not matter
    const std::uint32_t b = draft.add(8, {{{{0, 0}}, a}, {{{0, 1}}, draft.goal()}});
    EXPECT_EQ(draft.add(8, {{{{0, 1}}, draft.goal()}, {{{0, 0}}, a}}), b);
    EXPECT_EQ(draft.size(), 3u);
}

TEST(PlanDraft, EdgesSayWhereTheyDiffer) {
    PlanDraft draft;
    const std::uint32_t a = draft.add(7, {{{}, draft.goal()}});
    const std::uint32_t b = draft.add(8, {{{{0, 0}, {5, 1}, {6, 0}}, a}, {{{0, 1}, {5, 1}}, draft.goal()}});
    const ConditionalPlan plan = draft.finish(b);
    ASSERT_EQ(plan.size(), 3u);
    EXPECT_EQ(plan.action_nodes(), 2u);
    EXPECT_EQ(plan.depth(), 2u);
    const std::vector<Fact> first{{0, 0}, {6, 0}}, second{{0, 1}}, other{{0, 0}};
    EXPECT_EQ(plan.action(*plan.next(0, first)), 7u);
    EXPECT_TRUE(plan.goal(*plan.next(0, second)));
    EXPECT_EQ(plan.next(0, other), std::nullopt);  // nothing was said about variable 6
    for (const ConditionalPlan::Edge& edge : plan.edges(0)) EXPECT_EQ(plan.reports(edge).size(), 2u);
}

TEST(PlanDraft, LeavesOutWhatIsNotReached) {
    PlanDraft draft;
    const std::uint32_t a = draft.add(7, {{{}, draft.goal()}});
    draft.add(9, {{{}, a}});
    EXPECT_EQ(draft.finish(a).size(), 2u);
    EXPECT_TRUE(draft.finish(draft.goal()).goal(0));
}

TEST(ConditionalPlanner, PlansWorkInEveryWorldAndTheOptimumIsNotWorse) {
    int found = 0, missed = 0, branching = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const testing::Texts texts = testing::random_task(seed);
        SCOPED_TRACE(std::to_string(seed) + "\n" + texts.domain + "\n" + texts.problem);
        const auto task = testing::ground_random(texts);
        if (!task) continue;
        const KnowledgePlanner planner = planner_for(task);
        const OptimalPolicy best = optimal_policy(task);
        for (Reuse reuse : {Reuse::never, Reuse::after_answers, Reuse::everywhere}) {
            const ConditionalPlanResult made =
                make_conditional_plan(planner, best.worlds, planner_options(reuse));
            if (made.status != ConditionalPlanResult::Status::found) {
                missed += best.status == OptimalPolicy::Status::optimal;
                continue;
            }
            ASSERT_EQ(best.status, OptimalPolicy::Status::optimal);
            const ConditionalVerdict verdict = check_conditional_plan(task, made.plan, best.worlds);
            ASSERT_TRUE(verdict.valid) << verdict.reason;
            const auto costs = plan_costs(task, made.plan, best.worlds);
            ASSERT_TRUE(costs);
            ASSERT_LE(best.costs.mean, costs->mean + 1e-9);
            ++found;
            branching += made.plan.edge_count() >= made.plan.size();
        }
    }
    EXPECT_GE(found, 150);
    EXPECT_GE(branching, 50);
    EXPECT_LE(missed, found / 10);
}

TEST(ConditionalPlanner, WithoutCountingPlansOfRandomTasksWork) {
    int found = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        const testing::Texts texts = testing::random_task(seed);
        SCOPED_TRACE(std::to_string(seed) + "\n" + texts.domain + "\n" + texts.problem);
        const auto task = testing::ground_random(texts);
        if (!task) continue;
        const auto worlds = enumerate_worlds(*task, 100);
        const ConditionalPlanResult made =
            make_conditional_plan(planner_for(task), std::nullopt, planner_options(Reuse::never));
        if (made.status != ConditionalPlanResult::Status::found || worlds->empty()) continue;
        const ConditionalVerdict verdict = check_conditional_plan(task, made.plan, *worlds);
        ASSERT_TRUE(verdict.valid) << verdict.reason;
        ++found;
    }
    EXPECT_GE(found, 100);
}

TEST(ConditionalPlanner, WithoutCountingPlansWorkInEveryWorld) {
    const auto task = testing::ground(testing::corridor(3));
    const ConditionalPlanResult made =
        make_conditional_plan(planner_for(task), std::nullopt, planner_options(Reuse::never));
    ASSERT_EQ(made.status, ConditionalPlanResult::Status::found) << made.message;
    const auto worlds = enumerate_worlds(*task, 100);
    ASSERT_EQ(worlds->size(), 27u);
    const ConditionalVerdict verdict = check_conditional_plan(task, made.plan, *worlds);
    EXPECT_TRUE(verdict.valid) << verdict.reason;
}

TEST(ConditionalPlanner, TakesInWhatSensorsReadAtFirst) {
    const auto task = testing::ground(testing::corridor(2, true));
    const auto worlds = enumerate_worlds(*task, 100);
    const KnowledgePlanner planner = planner_for(task);
    const OptimalPolicy best = optimal_policy(task);
    ASSERT_EQ(best.status, OptimalPolicy::Status::optimal);
    EXPECT_EQ(best.plan.action(0), Environment::kStart);
    // No looks are needed.
    EXPECT_LT(best.costs.mean, optimal_policy(testing::ground(testing::corridor(2))).costs.mean);
    for (const bool counted : {false, true}) {
        const ConditionalPlanResult made = make_conditional_plan(planner, counted ? worlds : std::nullopt,
                                                                 planner_options(Reuse::everywhere));
        ASSERT_EQ(made.status, ConditionalPlanResult::Status::found) << made.message;
        EXPECT_EQ(made.plan.action(0), Environment::kStart);
        EXPECT_EQ(made.plan.edges(0).size(), 2u);
        const ConditionalVerdict verdict = check_conditional_plan(task, made.plan, *worlds);
        EXPECT_TRUE(verdict.valid) << verdict.reason;
        EXPECT_GE(plan_costs(task, made.plan, *worlds)->mean, best.costs.mean);
    }
}

TEST(ConditionalPlanner, KeepsItsLimits) {
    const auto task = testing::ground(testing::corridor(3));
    const KnowledgePlanner planner = planner_for(task);
    ConditionalPlannerOptions options = planner_options(Reuse::after_answers);
    options.most_nodes = 3;
    using Status = ConditionalPlanResult::Status;
    EXPECT_EQ(make_conditional_plan(planner, std::nullopt, options).status, Status::limit);
    options = planner_options(Reuse::after_answers);
    EXPECT_EQ(make_conditional_plan(planner, std::nullopt, options, Budget().limit_wall_time(0)).status,
              Status::limit);
}

TEST(CheckConditionalPlan, SaysInWhichWorldAPlanFails) {
    const auto task = testing::ground(testing::corridor(1));
    const auto worlds = enumerate_worlds(*task, 100);
    const OptimalPolicy one = optimal_policy(task, {worlds->front()});
    ASSERT_EQ(one.status, OptimalPolicy::Status::optimal);
    EXPECT_TRUE(check_conditional_plan(task, one.plan, {{worlds->front()}}).valid);
    const ConditionalVerdict verdict = check_conditional_plan(task, one.plan, *worlds);
    EXPECT_FALSE(verdict.valid);
    EXPECT_NE(verdict.reason.find("in world 1: "), std::string::npos) << verdict.reason;
    EXPECT_FALSE(plan_costs(task, one.plan, *worlds));
    EXPECT_FALSE(check_conditional_plan(task, {}, *worlds).valid);
}

TEST(Offline, FindsAPlanWhereThereIsOneAndProvesWhereThereIsNone) {
    int found = 0, unsolvable = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const testing::Texts texts = testing::random_task(seed);
        SCOPED_TRACE(std::to_string(seed) + "\n" + texts.domain + "\n" + texts.problem);
        const auto task = testing::ground_random(texts);
        if (!task) continue;
        const KnowledgePlanner planner = planner_for(task);
        const OfflineResult result = plan_offline(planner);
        const OptimalPolicy best = optimal_policy(task);
        if (best.status == OptimalPolicy::Status::unsolvable) {
            ASSERT_EQ(result.status, OfflineStatus::unsolvable);
            ++unsolvable;
            continue;
        }
        ASSERT_EQ(result.status, OfflineStatus::found) << result.message;
        ASSERT_TRUE(result.all_worlds && result.optimal);
        ASSERT_EQ(result.checked, best.worlds.size());
        ASSERT_NEAR(result.costs.mean, best.costs.mean, 1e-9);
        ++found;
    }
    EXPECT_GE(found, 40);
    EXPECT_GE(unsolvable, 20);
}

TEST(Offline, TextsTellWhatWasFoundOrWhyNot) {
    const auto task = testing::ground(testing::corridor(1));
    const KnowledgePlanner planner = planner_for(task);
    const OfflineResult result = plan_offline(planner);
    const OfflineTexts texts = offline_texts(*task, result, "corridor");
    EXPECT_NE(texts.summary.find("executed in all 3 first states; no plan costs less"), std::string::npos)
        << texts.summary;
    EXPECT_EQ(texts.text.substr(texts.text.size() - texts.summary.size() - 3), "; " + texts.summary + "\n");
    EXPECT_NE(texts.html.find(texts.summary), std::string::npos);
    EXPECT_FALSE(texts.dot.empty() || texts.json.empty());
    OfflineResult none;
    none.status = OfflineStatus::unsolvable;
    none.message = "no way";
    EXPECT_EQ(offline_texts(*task, none, "").summary, "unsolvable: no way");
    EXPECT_TRUE(offline_texts(*task, none, "").html.empty());
}

TEST(Offline, SaysThatReadingsWithErrorsLeaveNoSurePlan) {
    testing::Texts texts = testing::corridor(1);
    const std::string clean = ":observe (open ?q)";
    texts.domain.replace(texts.domain.find(clean), clean.size(), ":observe (probabilistic 0.9 (open ?q))");
    const auto task = testing::ground(texts);
    const KnowledgePlanner planner = planner_for(task);
    EXPECT_EQ(plan_offline(planner).status, OfflineStatus::unsupported);
}

TEST(Offline, SamplesWorldsThatAreTooMany) {
    const auto task = testing::ground(testing::corridor(3));
    const KnowledgePlanner planner = planner_for(task);
    OfflineOptions options;
    options.most_worlds = 10;
    options.samples = 50;
    const OfflineResult result = plan_offline(planner, options);
    ASSERT_EQ(result.status, OfflineStatus::found) << result.message;
    EXPECT_EQ(result.checked, 50u);
    EXPECT_FALSE(result.all_worlds || result.optimal);
}

}  // namespace
}  // namespace praxis::belief
