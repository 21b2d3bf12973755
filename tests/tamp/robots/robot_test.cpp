#include "tamp/robots/robot.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace praxis::tamp {
namespace {

/// Two links of one metre in the plane, turning about z, and a finger that slides by half of the second
/// angle.
Robot planar_arm() {
    Robot robot;
    robot.name = "planar";
    robot.links = {{.name = "root"},
                   {.name = "upper", .parent_joint = 0},
                   {.name = "lower", .parent_joint = 1},
                   {.name = "finger", .parent_joint = 2}};
    const Pose one_metre = pose_from_rpy({1, 0, 0}, Vector3::Zero());
    robot.joints = {{.name = "a", .type = JointType::revolute, .parent = 0, .child = 1, .variable = 0},
                    {.name = "b",
                     .type = JointType::revolute,
                     .parent = 1,
                     .child = 2,
                     .origin = one_metre,
                     .variable = 1},
                    {.name = "c",
                     .type = JointType::prismatic,
                     .parent = 2,
                     .child = 3,
                     .origin = one_metre,
                     .axis = Vector3::UnitX(),
                     .variable = 1,
                     .multiplier = 0.5,
                     .offset = 0.25}};
    robot.variables = {{.name = "a", .lower = -3, .upper = 3}, {.name = "b", .lower = 0.5, .upper = 2}};
    robot.groups = {{.name = "arm", .variables = {0, 1}, .tip = 2}};
    return robot;
}

TEST(Robot, ForwardKinematicsOfAPlanarArmByHand) {
    const Robot robot = planar_arm();
    check_robot(robot);
    const Configuration q = {std::numbers::pi / 2, -std::numbers::pi / 2};
    std::vector<Pose> poses(robot.links.size());
    forward_kinematics(robot, q, poses);
    // Up one metre, then along x by one metre and the finger's 0.25 - pi/4.
    const Vector3 finger = {1 + 0.25 - std::numbers::pi / 4, 1, 0};
    EXPECT_LT((poses[3].translation() - finger).norm(), 1e-12);
    EXPECT_TRUE(poses[3].linear().isIdentity(1e-12));
    EXPECT_TRUE(link_pose(robot, q, 3).isApprox(poses[3], 1e-12));
}

TEST(Robot, ZeroKeepsToTheLimits) {
    EXPECT_EQ(planar_arm().zero(), (Configuration{0, 0.5}));
}

TEST(Robot, LimitsAreForEveryVariableOfTheGroup) {
    const Robot robot = planar_arm();
    const Group& arm = robot.groups[0];
    EXPECT_TRUE(robot.within_limits(arm, Configuration{0, 1}));
    EXPECT_FALSE(robot.within_limits(arm, Configuration{0, 0.4}));
    EXPECT_FALSE(robot.within_limits(arm, Configuration{std::nan(""), 1}));
    EXPECT_FALSE(robot.within_limits(arm, Configuration{0}));
}

TEST(Robot, WrongRobotsAreRefusedByName) {
    const auto message = [](auto&& spoil) {
        Robot robot = planar_arm();
        spoil(robot);
        try {
            check_robot(robot);
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message([](Robot& r) { r.joints[1].axis = {0, 0, 2}; }).find("joint 'b'"), std::string::npos);
    EXPECT_NE(message([](Robot& r) { r.joints[2].child = 1; }).find("joint 'c'"), std::string::npos);
    EXPECT_NE(message([](Robot& r) { r.variables[0].upper = -4; }).find("variable 'a'"), std::string::npos);
    EXPECT_NE(message([](Robot& r) {
                  r.groups[0].variables = {1, 0};
              }).find("group 'arm'"),
              std::string::npos);
    EXPECT_NE(message([](Robot& r) { r.base.translation().x() = std::nan(""); }).find("base"),
              std::string::npos);
}

}  // namespace
}  // namespace praxis::tamp
