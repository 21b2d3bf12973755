#include "tamp/motion/inverse_kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "search/engines/random.hpp"
#include "tests/tamp/support/panda.hpp"

namespace praxis::tamp {
namespace {

double uniform(Random& random, double lower, double upper) {
    return lower + (upper - lower) * 0x1p-53 * static_cast<double>(random.next() >> 11);
}

Configuration random_positions(const Robot& robot, int group, Random& random) {
    Configuration positions;
    for (int variable : robot.groups[static_cast<std::size_t>(group)].variables) {
        const Variable& limits = robot.variables[static_cast<std::size_t>(variable)];
        positions.push_back(uniform(random, std::max(limits.lower, -std::numbers::pi),
                                    std::min(limits.upper, std::numbers::pi)));
    }
    return positions;
}

double position_error(const Pose& a, const Pose& b) {
    return (a.translation() - b.translation()).norm();
}

double rotation_error(const Pose& a, const Pose& b) {
    return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

/// The tool as the robot's own kinematics have it.
Pose reached(const Robot& robot, int group, const Pose& tool, const Configuration& positions) {
    const Group& moved = robot.groups[static_cast<std::size_t>(group)];
    Configuration all = robot.zero();
    robot.insert(moved, positions, all);
    return link_pose(robot, all, moved.tip) * tool;
}

/// A slide along z, an arm of two metres in the plane, and a finger that follows the elbow by a half.
std::shared_ptr<const Robot> scara() {
    Robot robot;
    robot.name = "scara";
    robot.base = pose_from_rpy({0.3, -0.2, 0.1}, {0.1, 0.2, 0.3});
    robot.links = {{.name = "root"},
                   {.name = "carriage", .parent_joint = 0},
                   {.name = "upper", .parent_joint = 1},
                   {.name = "lower", .parent_joint = 2},
                   {.name = "finger", .parent_joint = 3}};
    const Pose one_metre = pose_from_rpy({1, 0, 0}, Vector3::Zero());
    robot.joints = {
        {.name = "lift", .type = JointType::prismatic, .parent = 0, .child = 1, .variable = 0},
        {.name = "shoulder", .type = JointType::continuous, .parent = 1, .child = 2, .variable = 1},
        {.name = "elbow",
         .type = JointType::revolute,
         .parent = 2,
         .child = 3,
         .origin = one_metre,
         .variable = 2},
        {.name = "follower",
         .type = JointType::prismatic,
         .parent = 3,
         .child = 4,
         .origin = one_metre,
         .axis = Vector3(3, 0, 4) / 5,
         .variable = 2,
         .multiplier = 0.5,
         .offset = 0.25}};
    robot.variables = {{.name = "lift", .lower = 0, .upper = 1},
                       {.name = "shoulder", .continuous = true},
                       {.name = "elbow", .lower = -2, .upper = 2}};
    robot.groups = {{.name = "all", .variables = {0, 1, 2}, .tip = 4},
                    {.name = "lift", .variables = {0}, .tip = 4}};
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

TEST(KinematicChain, AgreesWithTheRobotsKinematics) {
    Random random(1);
    for (const auto& [robot, group] : {std::pair{panda_arm(), 0}, {panda_arm(true), 1}, {scara(), 0}}) {
        const Pose tool = pose_from_rpy({0.1, 0.2, 0.3}, {0.4, 0.5, 0.6});
        const KinematicChain chain(*robot, group, robot->groups[static_cast<std::size_t>(group)].tip, tool,
                                   robot->zero());
        for (int i = 0; i < 20; ++i) {
            const Configuration positions = random_positions(*robot, group, random);
            const Pose pose = to_pose(chain.forward(positions.data()));
            EXPECT_TRUE(pose.isApprox(reached(*robot, group, tool, positions), 1e-12)) << robot->name;
            double squared = 0;
            for (int k = 0; k < 3; ++k) {
                const double d = pose(k, 3) - chain.reach().center[static_cast<std::size_t>(k)];
                squared += d * d;
            }
            EXPECT_LE(std::sqrt(squared), chain.reach().radius);
        }
    }
}

TEST(KinematicChain, JacobianIsTheDerivative) {
    Random random(2);
    constexpr double kStep = 1e-6;
    for (const auto& [robot, group] : {std::pair{panda_arm(true), 1}, {scara(), 0}}) {
        const KinematicChain chain(*robot, group, robot->groups[static_cast<std::size_t>(group)].tip,
                                   Pose::Identity(), robot->zero());
        const Configuration positions = random_positions(*robot, group, random);
        Jacobian jacobian;
        const Pose pose = to_pose(chain.forward(positions.data(), jacobian));
        for (std::size_t j = 0; j < positions.size(); ++j) {
            Configuration moved = positions;
            moved[j] += kStep;
            const Pose after = to_pose(chain.forward(moved.data()));
            const Vector3 linear = (after.translation() - pose.translation()) / kStep;
            const Eigen::AngleAxisd turn(after.linear() * pose.linear().transpose());
            const Vector3 angular = turn.angle() / kStep * turn.axis();
            EXPECT_LT((linear - Eigen::Map<const Vector3>(jacobian.linear[j].data())).norm(), 1e-5);
            EXPECT_LT((angular - Eigen::Map<const Vector3>(jacobian.angular[j].data())).norm(), 1e-4);
        }
    }
}

TEST(InverseKinematics, SolvesReachableTargetsWithinLimitsAndTolerances) {
    Random random(3);
    const Pose tool = pose_from_rpy({0, 0, 0.1}, {0, 0, 1});
    for (const auto& [robot, group] : {std::pair{panda_arm(), 0}, {panda_arm(true), 1}, {scara(), 0}}) {
        const Group& moved = robot->groups[static_cast<std::size_t>(group)];
        const InverseKinematics ik(robot, group, moved.tip, tool);
        for (int i = 0; i < 200; ++i) {
            const Pose target = reached(*robot, group, tool, random_positions(*robot, group, random));
            const IkResult result = ik.solve(target);
            ASSERT_TRUE(result) << robot->name << " target " << i;
            EXPECT_TRUE(robot->within_limits(moved, result.positions));
            const Pose pose = reached(*robot, group, tool, result.positions);
            EXPECT_LE(position_error(pose, target), 1.01e-5);
            EXPECT_LE(rotation_error(pose, target), 1.01e-4);
        }
    }
}

TEST(InverseKinematics, TasksLeaveFreeWhatTheySay) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const int tip = robot->groups[0].tip;
    const InverseKinematics ik(robot, 0, tip);
    // The roll about the tool's axis and whole orientations that this place cannot have.
    for (double roll = -3; roll <= 3; roll += 0.5) {
        const Pose target = pose_from_rpy({0.4, 0.2, 0.3}, {std::numbers::pi, 0, roll});
        const IkResult axis = ik.solve(target, {.task = IkTask::position_and_axis});
        ASSERT_TRUE(axis);
        const Pose pose = reached(*robot, 0, Pose::Identity(), axis.positions);
        EXPECT_LE(position_error(pose, target), 1.01e-5);
        EXPECT_GT(pose.linear().col(2).dot(target.linear().col(2)), std::cos(1.01e-4));
    }
    const Pose folded = pose_from_rpy({0.8, 0, 0.5}, {0, -std::numbers::pi / 2, 0});
    EXPECT_FALSE(ik.solve(folded));
    const IkResult place = ik.solve(folded, {.task = IkTask::position});
    ASSERT_TRUE(place);
    EXPECT_LE(position_error(reached(*robot, 0, Pose::Identity(), place.positions), folded), 1.01e-5);
}

TEST(InverseKinematics, FewerVariablesThanSixWhereTheTargetAllowsIt) {
    const std::shared_ptr<const Robot> robot = scara();
    const InverseKinematics lift(robot, 1, 4);
    const Pose target = reached(*robot, 0, Pose::Identity(), {0.7, 0, 0});
    const IkResult result = lift.solve(target);
    ASSERT_TRUE(result);
    EXPECT_NEAR(result.positions.at(0), 0.7, 1e-5);
    EXPECT_EQ(lift.solve(reached(*robot, 0, Pose::Identity(), {0.7, 1, 0})).status, IkStatus::not_found);
}

TEST(InverseKinematics, FurtherThanTheChainIsLongIsProved) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const InverseKinematics ik(robot, 0, robot->groups[0].tip);
    const IkResult result = ik.solve(pose_from_rpy({1.5, 0, 0.3}, Vector3::Zero()));
    EXPECT_EQ(result.status, IkStatus::out_of_reach);
    EXPECT_EQ(result.attempts, 0);
    EXPECT_TRUE(ik.solve_all(pose_from_rpy({1.5, 0, 0.3}, Vector3::Zero()), 3).empty());
}

TEST(InverseKinematics, StartsAtTheGivenConfiguration) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const InverseKinematics ik(robot, 0, robot->groups[0].tip);
    const Configuration start = {0.3, 0.4, -0.5, -1.6, 0.2, 1.7, 0.1};
    Pose target = ik.forward(start);
    target.translation().x() += 0.01;
    const IkResult result = ik.solve(target, {.start = start});
    ASSERT_TRUE(result);
    EXPECT_EQ(result.attempts, 1);
    for (std::size_t j = 0; j < start.size(); ++j) EXPECT_NEAR(result.positions[j], start[j], 0.1);
}

TEST(InverseKinematics, TurnsWithoutLimitsComeOutNearTheStart) {
    const std::shared_ptr<const Robot> robot = scara();
    const InverseKinematics ik(robot, 0, 4);
    const Pose target = ik.forward(Configuration{0.5, 3, 0.7});
    const IkResult result = ik.solve(target, {.start = Configuration{0.5, 3 - 4 * std::numbers::pi, 0.7}});
    ASSERT_TRUE(result);
    EXPECT_NEAR(result.positions[1], 3 - 4 * std::numbers::pi, 1e-3);
    const IkResult from_nowhere = ik.solve(target);
    ASSERT_TRUE(from_nowhere);
    EXPECT_NEAR(from_nowhere.positions[1], 3, 1e-3);
}

TEST(InverseKinematics, ThePostureIsApproachedAsFarAsTheTaskAllows) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const InverseKinematics ik(robot, 0, robot->groups[0].tip);
    const Configuration posture = {0, 0, 0, -1.6, 0, 1.8, 0};
    const auto away = [&](const Configuration& positions) {
        double squared = 0;
        for (std::size_t j = 0; j < posture.size(); ++j) {
            squared += (positions[j] - posture[j]) * (positions[j] - posture[j]);
        }
        return std::sqrt(squared);
    };
    Random random(5);
    double with = 0;
    double without = 0;
    for (int i = 0; i < 50; ++i) {
        const Pose target = ik.forward(random_positions(*robot, 0, random));
        const IkResult pulled = ik.solve(target, {.posture = posture});
        ASSERT_TRUE(pulled);
        EXPECT_LE(position_error(ik.forward(pulled.positions), target), 1.01e-5);
        EXPECT_LE(rotation_error(ik.forward(pulled.positions), target), 1.01e-4);
        with += away(pulled.positions);
        without += away(ik.solve(target).positions);
    }
    EXPECT_LT(with, 0.9 * without);
    // Where the posture reaches the target, it is the solution.
    const IkResult exact =
        ik.solve(ik.forward(posture), {.start = Configuration(7, 0.1), .posture = posture});
    ASSERT_TRUE(exact);
    EXPECT_LT(away(exact.positions), 0.05);
}

TEST(InverseKinematics, SeveralSolutionsAreDistinct) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const InverseKinematics ik(robot, 0, robot->groups[0].tip);
    const Pose target = pose_from_rpy({0.4, 0.2, 0.3}, {std::numbers::pi, 0, 0.5});
    const std::vector<Configuration> solutions = ik.solve_all(target, 12, {.distinct = 0.2});
    ASSERT_EQ(solutions.size(), 12U);
    for (std::size_t a = 0; a < solutions.size(); ++a) {
        EXPECT_LE(position_error(ik.forward(solutions[a]), target), 1.01e-5);
        for (std::size_t b = 0; b < a; ++b) {
            double most = 0;
            for (std::size_t j = 0; j < 7; ++j) {
                most = std::max(most, std::abs(solutions[a][j] - solutions[b][j]));
            }
            EXPECT_GT(most, 0.2);
        }
    }
    EXPECT_EQ(ik.solve_all(target, 12, {.distinct = 0.2}), solutions);
    EXPECT_NE(ik.solve_all(target, 12, {.seed = 1, .distinct = 0.2}), solutions);
    EXPECT_TRUE(ik.solve_all(target, 0).empty());
}

TEST(InverseKinematics, AnElbowIsLeftOrRight) {
    Robot planar = *scara();
    planar.links.pop_back();
    planar.joints.pop_back();
    planar.groups = {{.name = "all", .variables = {0, 1, 2}, .tip = 3}};
    const InverseKinematics ik(std::make_shared<const Robot>(planar), 0, 3,
                               pose_from_rpy({1, 0, 0}, Vector3::Zero()));
    const Pose target = ik.forward(Configuration{0.5, 0.2, 0.7});
    EXPECT_EQ(ik.solve_all(target, 10, {.task = IkTask::position}).size(), 2U);
    EXPECT_EQ(ik.solve_all(target, 10).size(), 1U);
}

TEST(InverseKinematics, AClosedFormIsCheckedBeforeItCounts) {
    const std::shared_ptr<const Robot> robot = scara();
    const InverseKinematics plain(robot, 0, 4);
    const Configuration truth = {0.5, 1, 0.7};
    const Pose target = plain.forward(truth);
    int asked = 0;
    const InverseKinematics ik(robot, 0, 4, Pose::Identity(), {},
                               [&](const Pose&, std::vector<Configuration>& candidates) {
                                   ++asked;
                                   candidates = {{0.5, 1, 9},  // out of limits
                                                 {0.5, 1},     // wrong size
                                                 {0.5, 1, std::nan("")},
                                                 {0.1, 0, 0},          // not there
                                                 {0.5, 1.0001, 0.7}};  // nearly
                               });
    const IkResult result = ik.solve(target);
    ASSERT_TRUE(result);
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(result.attempts, 1);
    EXPECT_LE(position_error(ik.forward(result.positions), target), 1.01e-5);
    EXPECT_NEAR(result.positions[1], 1, 1e-4);
}

TEST(InverseKinematics, WrongUseIsRefused) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const int tip = robot->groups[0].tip;
    const InverseKinematics ik(robot, 0, tip);
    Pose nowhere = Pose::Identity();
    nowhere.translation().x() = std::nan("");
    EXPECT_THROW(ik.solve(nowhere), std::invalid_argument);
    const Pose target = ik.forward(Configuration(7, 0));
    EXPECT_THROW(ik.solve(target, {.position_tolerance = 0}), std::invalid_argument);
    EXPECT_THROW(ik.solve(target, {.start = Configuration(6, 0)}), std::invalid_argument);
    EXPECT_THROW(ik.solve(target, {.posture = Configuration(7, std::nan(""))}), std::invalid_argument);
    EXPECT_THROW(ik.solve(target, {.attempts = 0}), std::invalid_argument);
    EXPECT_THROW(ik.forward(Configuration(8, 0)), std::invalid_argument);
    EXPECT_THROW(InverseKinematics(robot, 1, tip), std::invalid_argument);
    EXPECT_THROW(InverseKinematics(robot, 0, 99), std::invalid_argument);
    EXPECT_THROW(InverseKinematics(robot, 0, 0), std::invalid_argument);
    EXPECT_THROW(InverseKinematics(robot, 0, tip, nowhere), std::invalid_argument);
    EXPECT_THROW(InverseKinematics(robot, 0, tip, Pose::Identity(), Configuration(3, 0)),
                 std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
