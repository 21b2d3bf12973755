// Blocks on a line: the whole way from files to values.
#include <gtest/gtest.h>

#include "tests/tamp/support/line_world.hpp"

namespace praxis::tamp {
namespace {

using test::LineWorld;

/// Executes a refined plan on numbers, and says what is wrong with it; empty: nothing.
std::string check_line_plan(const RefinedPlan& plan, std::map<std::string, double> blocks, double width,
                            double home, const test::Interval& reach) {
    double gripper = home;
    std::string held;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const RefinedStep& step = plan.steps[i];
        const auto number = [&](std::size_t k) { return step.arguments[k].get<double>(); };
        if (step.name == "move") {
            if (number(0) != gripper) return plan.action(i) + " starts elsewhere";
            gripper = number(2);
            continue;
        }
        const std::string block = step.arguments[0].name();
        if (number(3) != gripper || number(1) != gripper)
            return plan.action(i) + ": the gripper is elsewhere";
        if (gripper < reach.low || gripper > reach.high) return plan.action(i) + ": out of reach";
        if (step.name == "pick") {
            if (!held.empty() || !blocks.contains(block) || blocks[block] != number(1))
                return plan.action(i) + ": it is not there";
            blocks.erase(block);
            held = block;
        } else {
            if (held != block) return plan.action(i) + ": not held";
            for (const auto& [other, position] : blocks)
                if (std::abs(position - number(1)) < width) return plan.action(i) + " hits " + other;
            blocks[block] = number(1);
            held.clear();
        }
    }
    return held.empty() ? "" : "still held: " + held;
}

double last_pose(const RefinedPlan& plan, const std::string& block) {
    double result = NAN;
    for (const RefinedStep& step : plan.steps)
        if (step.name == "place" && step.arguments[0].name() == block)
            result = step.arguments[1].get<double>();
    return result;
}

TEST(Line, TightNeedsNineActionsAndTwoPosesThatFit) {
    const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "tight");
    const StreamLibrary library = LineWorld{}.library();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RefinementProblem problem{&task, &library, test::tight_values(), {}};
        problem.options.seed = seed;
        const Refinement result = refine(problem);
        ASSERT_EQ(result.status, RefineStatus::solved) << seed;
        EXPECT_EQ(result.plan->steps.size(), 9u);
        EXPECT_EQ(check_line_plan(*result.plan, {{"a", -2}, {"b", -4}}, 1, 0, {-100, 100}), "");
        EXPECT_EQ(result.plan->steps.back().arguments[2].name(), "home");
        for (const char* block : {"a", "b"}) {
            EXPECT_GE(last_pose(*result.plan, block), 5.5);
            EXPECT_LE(last_pose(*result.plan, block), 7);
        }
        EXPECT_GT(result.plan->cost, 4);
    }
}

TEST(Line, BlockedMovesTheBlockThatIsInTheWay) {
    const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "blocked");
    const StreamLibrary library = LineWorld{}.library();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RefinementProblem problem{&task, &library, test::blocked_values(), {}};
        problem.options.seed = seed;
        const Refinement result = refine(problem);
        ASSERT_EQ(result.status, RefineStatus::solved) << seed;
        EXPECT_EQ(check_line_plan(*result.plan, {{"a", -2}, {"b", 5.75}}, 1, 0, {-100, 100}), "");
        EXPECT_EQ(result.plan->steps.size(), 9u) << "b away, then a there";
        EXPECT_LT(last_pose(*result.plan, "b"), 0);
    }
}

TEST(Line, TwoBlocksDoNotFitWhereThereIsRoomForOne) {
    const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "tight");
    LineWorld world;
    world.poses = 8;
    const StreamLibrary library = world.library();
    RefinementProblem problem{&task, &library, test::tight_values(), {}};
    problem.values["red"] = Value::of(test::Interval{5, 6.9});
    const Refinement result = refine(problem);
    EXPECT_EQ(result.status, RefineStatus::infeasible);
    EXPECT_TRUE(result.statistics.exact);
    EXPECT_FALSE(result.reasons.empty());
    ASSERT_FALSE(result.attempts.empty());
    EXPECT_EQ(result.attempts.front().stream, "test-apart");
    problem.values["red"] = Value::of(test::Interval{5, 7});
    EXPECT_EQ(refine(problem).status, RefineStatus::solved) << "just wide enough, at the grid's ends";
}

TEST(Line, WhatIsOutOfReachIsProved) {
    const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "tight");
    LineWorld world;
    world.poses = 8;
    world.reach = {-20, 4};
    const StreamLibrary library = world.library();
    const RefinementProblem problem{&task, &library, test::tight_values(), {}};
    const Refinement result = refine(problem);
    EXPECT_EQ(result.status, RefineStatus::infeasible);
    EXPECT_TRUE(result.statistics.rejections.contains("inverse-kinematics"));
    world.reach = {-20, 7};
    const StreamLibrary enough = world.library();
    EXPECT_EQ(refine({&task, &enough, test::tight_values(), {}}).status, RefineStatus::solved);
}

TEST(Line, NothingIsProvedOfStreamsWithoutEnd) {
    const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, "tight");
    const StreamLibrary library = LineWorld{}.library();
    RefinementProblem problem{&task, &library, test::tight_values(), {}};
    problem.values["red"] = Value::of(test::Interval{5, 6.9});
    Budget budget;
    budget.limit_wall_time(0.2);
    const Refinement result = refine(problem, budget);
    EXPECT_EQ(result.status, RefineStatus::out_of_budget);
    EXPECT_FALSE(result.attempts.empty());
}

}  // namespace
}  // namespace praxis::tamp
