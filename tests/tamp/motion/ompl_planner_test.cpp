#include "tamp/motion/ompl_planner.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>

#include "tamp/motion/inverse_kinematics.hpp"
#include "tests/tamp/support/panda.hpp"
#include "tests/tamp/support/point_checker.hpp"

namespace praxis::tamp {
namespace {

const bool seeded = seed_ompl(1);

/// A wall across the square with a gap at the top.
bool in_wall(std::span<const double> at) {
    return at[0] > 4.5 && at[0] < 5.5 && at[1] < 7;
}

void expect_free(PointChecker& checker, const Path& path) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        EXPECT_TRUE(checker.is_motion_free(path[i - 1], path[i], kCheckStep));
    }
}

OmplOptions within(double seconds, const std::string& planner = "RRTConnect") {
    OmplOptions options;
    options.planner = planner;
    options.budget.limit_wall_time(seconds);
    return options;
}

TEST(Ompl, IsSeededOnce) {
    EXPECT_TRUE(seeded);
    EXPECT_FALSE(seed_ompl(2));
    EXPECT_THROW(seed_ompl(0), std::invalid_argument);
}

class EveryPlanner : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryPlanner, GoesAroundAWall) {
    PointChecker checker(point_robot(), in_wall);
    const std::vector<Configuration> goals = {{8, 6}};
    const OmplResult result = plan_with_ompl(checker, Configuration{2, 6}, goals, within(10, GetParam()));
    ASSERT_EQ(result.status, OmplStatus::solved);
    EXPECT_EQ(result.path.front(), (Configuration{2, 6}));
    EXPECT_NEAR(result.path.back()[0], 8, 1e-9);
    EXPECT_NEAR(result.path.back()[1], 6, 1e-9);
    EXPECT_GT(result.motions, 0U);
    expect_free(checker, result.path);
}

INSTANTIATE_TEST_SUITE_P(Ompl, EveryPlanner, ::testing::ValuesIn(ompl_planner_names()),
                         [](const auto& test) { return test.param; });

TEST(Ompl, ABaseTurnsTheShortWayRound) {
    // A stick of two metres: it fits through the gap only along.
    const auto robot = point_robot(true);
    const auto stick_touches = [](std::span<const double> at) {
        for (double along = -1; along <= 1; along += 0.1) {
            const double x = at[0] + along * std::cos(at[2]);
            const double y = at[1] + along * std::sin(at[2]);
            if (x > 4.5 && x < 5.5 && (y < 7 || y > 8)) return true;
        }
        return false;
    };
    PointChecker checker(robot, stick_touches);
    const Configuration start = {2, 6, 3 + 2 * std::numbers::pi};
    const std::vector<Configuration> goals = {{5, 3, 0}, {8, 6, -3}};
    const OmplResult result = plan_with_ompl(checker, start, goals, within(20));
    ASSERT_EQ(result.status, OmplStatus::solved);
    EXPECT_EQ(result.goal, 1);
    EXPECT_EQ(result.path.front(), start);
    expect_free(checker, result.path);
    for (std::size_t i = 1; i < result.path.size(); ++i) {
        EXPECT_LE(std::abs(result.path[i][2] - result.path[i - 1][2]), std::numbers::pi);
    }
    EXPECT_NEAR(std::remainder(result.path.back()[2] + 3, 2 * std::numbers::pi), 0, 1e-9);
    // Nothing in the way: straight, over the half turn.
    PointChecker empty(robot, [](std::span<const double>) { return false; });
    const OmplResult direct = plan_with_ompl(empty, start, {{Configuration{2, 6, -3}}}, within(10));
    ASSERT_EQ(direct.status, OmplStatus::solved);
    EXPECT_NEAR(direct.path.back()[2], 4 * std::numbers::pi - 3, 1e-9);
}

TEST(Ompl, AnArmGoesOverAWall) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const InverseKinematics ik(robot, 0, robot->groups[0].tip);
    PointChecker checker(robot, [&](std::span<const double> at) {
        const Vector3 hand = ik.forward(at).translation();
        return hand.z() < 0.02 || (std::abs(hand.y()) < 0.1 && hand.z() < 0.5);
    });
    const IkResult left = ik.solve(pose_from_rpy({0.4, 0.3, 0.2}, {std::numbers::pi, 0, 0}));
    const IkResult right = ik.solve(pose_from_rpy({0.4, -0.3, 0.2}, {std::numbers::pi, 0, 0}));
    ASSERT_TRUE(left);
    ASSERT_TRUE(right);
    for (const std::string planner : {"RRTConnect", "KPIECE1", "BITstar"}) {
        const OmplResult result =
            plan_with_ompl(checker, left.positions, {{right.positions}}, within(20, planner));
        ASSERT_EQ(result.status, OmplStatus::solved) << planner;
        expect_free(checker, result.path);
    }
}

TEST(Ompl, WhatIsImpossibleEndsWithTheBudget) {
    PointChecker checker(point_robot(), [](std::span<const double> at) { return at[0] > 4 && at[0] < 6; });
    for (const std::string planner : {"RRTConnect", "PRM", "RRTstar", "BITstar"}) {
        const auto begin = std::chrono::steady_clock::now();
        const OmplResult result =
            plan_with_ompl(checker, Configuration{2, 5}, {{Configuration{8, 5}}}, within(0.05, planner));
        const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
        EXPECT_EQ(result.status, OmplStatus::out_of_budget) << planner;
        EXPECT_TRUE(result.path.empty());
        EXPECT_LT(elapsed.count(), 5);
    }
    std::stop_source stop;
    stop.request_stop();
    OmplOptions stopped;
    stopped.budget.stop_with(stop.get_token());
    EXPECT_EQ(plan_with_ompl(checker, Configuration{2, 5}, {{Configuration{8, 5}}}, stopped).status,
              OmplStatus::out_of_budget);
}

TEST(Ompl, ImprovesWhileTheBudgetLasts) {
    PointChecker checker(point_robot(), in_wall);
    OmplOptions options = within(0.2, "RRTstar");
    options.improve = true;
    const OmplResult result = plan_with_ompl(checker, Configuration{2, 6}, {{Configuration{8, 6}}}, options);
    ASSERT_EQ(result.status, OmplStatus::solved);
    EXPECT_NE(options.budget.exhausted(), Stop::none);
    const double shortest = 1 + 2 * std::hypot(2.5, 1);
    EXPECT_LT(path_length(result.path), 1.25 * shortest);
    expect_free(checker, result.path);
}

TEST(Ompl, StartsAndGoalsThatCannotBe) {
    PointChecker checker(point_robot(), in_wall);
    const Configuration free = {2, 6};
    EXPECT_EQ(plan_with_ompl(checker, Configuration{5, 5}, {{free}}).status, OmplStatus::start_invalid);
    EXPECT_EQ(plan_with_ompl(checker, Configuration{11, 5}, {{free}}).status, OmplStatus::start_invalid);
    const std::vector<Configuration> bad = {{5, 5}, {-1, 0}};
    EXPECT_EQ(plan_with_ompl(checker, free, bad).status, OmplStatus::goals_invalid);
}

TEST(Ompl, WrongUseIsRefused) {
    PointChecker checker(point_robot(), in_wall);
    const Configuration free = {2, 6};
    try {
        plan_with_ompl(checker, free, {{free}}, within(1, "RRTConect"));
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()), "OMPL: no planner 'RRTConect'; did you mean 'RRTConnect'?");
    }
    EXPECT_THROW(plan_with_ompl(checker, free, {}), std::invalid_argument);
    EXPECT_THROW(plan_with_ompl(checker, Configuration{1}, {{free}}), std::invalid_argument);
    EXPECT_THROW(plan_with_ompl(checker, free, {{Configuration{1, std::nan("")}}}), std::invalid_argument);
    OmplOptions options;
    options.step = 0;
    EXPECT_THROW(plan_with_ompl(checker, free, {{free}}, options), std::invalid_argument);
    Robot unbounded = *point_robot();
    unbounded.variables[0].upper = std::numeric_limits<double>::infinity();
    PointChecker open(std::make_shared<const Robot>(unbounded), in_wall);
    EXPECT_THROW(plan_with_ompl(open, free, {{free}}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
