#include "tamp/robots/builtin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <numbers>
#include <stdexcept>

#include "tamp/robots/dh.hpp"
#include "tests/tamp/robots/robot_checks.hpp"

namespace praxis::tamp {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

/// Published modified Denavit-Hartenberg parameters: a, alpha, d.
constexpr std::array<std::array<double, 3>, 7> kRows = {{{0, 0, 0.333},
                                                         {0, -kQuarter, 0},
                                                         {0, kQuarter, 0.316},
                                                         {0.0825, kQuarter, 0},
                                                         {-0.0825, -kQuarter, 0.384},
                                                         {0, kQuarter, 0},
                                                         {0.088, kQuarter, 0}}};

Pose tool_pose(const Robot& robot, const Configuration& q) {
    const EndEffector& hand = robot.end_effectors.at(0);
    return link_pose(robot, q, hand.link) * hand.tool;
}

TEST(Builtin, KinematicsOfArm7AreThoseOfItsTable) {
    const Robot robot = builtin_robot("arm7");
    DhTable table{.name = "table"};
    for (std::size_t i = 0; i < kRows.size(); ++i) {
        table.rows.push_back({.joint = "j" + std::to_string(i),
                              .link = "l" + std::to_string(i),
                              .a = kRows[i][0],
                              .alpha = kRows[i][1],
                              .d = kRows[i][2]});
    }
    const Robot from_table = make_dh_robot(table);
    const Pose hand =
        pose_from_rpy({0, 0, 0.107}, {0, 0, -kQuarter / 2}) * pose_from_rpy({0, 0, 0.1034}, {0, 0, 0});
    Random random(7);
    for (int i = 0; i < 100; ++i) {
        const Configuration q = random_configuration(robot, random);
        Pose product = Pose::Identity();
        for (std::size_t row = 0; row < kRows.size(); ++row) {
            product = product * dh_transform(table.rows[row], table.convention, q[row]);
        }
        const Configuration arm(q.begin(), q.begin() + 7);
        const Pose tool = tool_pose(robot, q);
        EXPECT_LT(((product * hand).matrix() - tool.matrix()).cwiseAbs().maxCoeff(), 1e-9);
        EXPECT_LT(((link_pose(from_table, arm, 7) * hand).matrix() - tool.matrix()).cwiseAbs().maxCoeff(),
                  1e-9);
    }
}

TEST(Builtin, KinematicsOfArm7AreThoseOfKdl) {
    const Robot robot = builtin_robot("arm7");
    KDL::Chain chain;
    for (const auto& [a, alpha, d] : kRows) {
        chain.addSegment(
            KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame::DH_Craig1989(a, alpha, d, 0)));
        chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ)));
    }
    chain.addSegment(
        KDL::Segment(KDL::Joint(KDL::Joint::None),
                     KDL::Frame(KDL::Rotation::RotZ(-kQuarter / 2), KDL::Vector(0, 0, 0.107 + 0.1034))));
    KDL::ChainFkSolverPos_recursive solver(chain);
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const Configuration q = random_configuration(robot, random);
        KDL::JntArray positions(7);
        for (unsigned j = 0; j < 7; ++j) positions(j) = q[j];
        KDL::Frame frame;
        ASSERT_GE(solver.JntToCart(positions, frame), 0);
        const Pose tool = tool_pose(robot, q);
        for (int row = 0; row < 3; ++row) {
            EXPECT_NEAR(frame.p(row), tool.translation()[row], 1e-9);
            for (int column = 0; column < 3; ++column) {
                EXPECT_NEAR(frame.M(row, column), tool.linear()(row, column), 1e-9);
            }
        }
    }
}

TEST(Builtin, TheHandPointsDownWhenReady) {
    const Robot robot = builtin_robot("arm7");
    Configuration q = robot.zero();
    for (const NamedState& state : robot.states) {
        if (state.name == "ready") robot.insert(robot.groups[0], state.positions, q);
    }
    const Pose tool = tool_pose(robot, q);
    EXPECT_TRUE(tool.linear().isApprox(Eigen::Matrix3d(Vector3(1, -1, -1).asDiagonal()), 1e-9));
    // From finger to finger is y of the tool.
    q[static_cast<std::size_t>(robot.find_variable("left_finger_joint"))] = 0.04;
    const Vector3 left = link_pose(robot, q, robot.find_link("left_finger")).translation();
    const Vector3 right = link_pose(robot, q, robot.find_link("right_finger")).translation();
    EXPECT_LT((left - right - 0.08 * tool.linear().col(1)).norm(), 1e-9);
}

TEST(Builtin, TheMobileArmIsTheArmOnAPlatform) {
    const Robot arm = builtin_robot("arm7");
    const Robot mobile = builtin_robot("mobile-arm7");
    ASSERT_EQ(mobile.variables.size(), arm.variables.size() + 3);
    EXPECT_TRUE(mobile.variables[2].continuous);
    const Group& all = mobile.groups[static_cast<std::size_t>(mobile.find_group("base_arm"))];
    EXPECT_EQ(all.variables.size(), 10U);
    EXPECT_EQ(all.tip, mobile.find_link("hand"));
    EXPECT_EQ(mobile.groups[static_cast<std::size_t>(mobile.find_group("base"))].tip,
              mobile.find_link("platform"));
    Random random(9);
    const Configuration q = random_configuration(arm, random);
    Configuration whole = {1, 2, 0.5};
    whole.insert(whole.end(), q.begin(), q.end());
    const Pose foot = pose_from_rpy({1, 2, 0.4}, {0, 0, 0.5});
    EXPECT_TRUE((foot * tool_pose(arm, q)).isApprox(tool_pose(mobile, whole), 1e-12));
    EXPECT_EQ(mobile.variables[3].max_acceleration, 15);
}

TEST(Builtin, HandsKnowTheirOpenings) {
    for (const std::string& name : builtin_robot_names()) {
        const Robot robot = builtin_robot(name);
        ASSERT_EQ(robot.end_effectors.size(), 1U);
        const EndEffector& hand = robot.end_effectors[0];
        EXPECT_EQ(hand.name, "hand");
        EXPECT_EQ(hand.arm, "arm");
        EXPECT_EQ(hand.gripper, "gripper");
        EXPECT_EQ(hand.max_opening, 0.08);
        EXPECT_EQ(hand.open, Configuration{0.04});
        EXPECT_EQ(hand.closed, Configuration{0});
        EXPECT_EQ(hand.links.size(), 3U);
        EXPECT_EQ(hand.link, robot.groups[static_cast<std::size_t>(robot.find_group("arm"))].tip);
    }
}

TEST(Builtin, NamedStatesAreFreeOfCollisions) {
    for (const std::string& name : builtin_robot_names()) {
        const Robot robot = builtin_robot(name);
        std::vector<Pose> poses(robot.links.size());
        for (const char* state_name : {"home", "ready"}) {
            Configuration q = robot.zero();
            std::size_t found = 0;
            for (const NamedState& state : robot.states) {
                if (state.name != state_name || state.group != "arm") continue;
                robot.insert(robot.groups[static_cast<std::size_t>(robot.find_group("arm"))], state.positions,
                             q);
                ++found;
            }
            ASSERT_EQ(found, 1U);
            forward_kinematics(robot, q, poses);
            for (int first = 0; first < static_cast<int>(robot.links.size()); ++first) {
                for (int second = first + 1; second < static_cast<int>(robot.links.size()); ++second) {
                    if (!robot.may_collide(first, second)) continue;
                    EXPECT_GT(clearance(robot, poses, first, second), 0.02)
                        << robot.links[static_cast<std::size_t>(first)].name << ' '
                        << robot.links[static_cast<std::size_t>(second)].name;
                }
            }
        }
    }
}

TEST(Builtin, PairsThatAreNeverCheckedNeverMeet) {
    const Robot robot = builtin_robot("mobile-arm7", {0.001, 3000});
    const auto are_neighbours = [&](int first, int second) {
        for (const Joint& joint : robot.joints) {
            if (joint.parent == first && joint.child == second) return true;
        }
        return false;
    };
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [first, second] : robot.allowed_collisions) {
        // Closed fingers touch: that is what they are for.
        const bool fingers =
            first == robot.find_link("left_finger") && second == robot.find_link("right_finger");
        if (!are_neighbours(first, second) && !fingers) pairs.emplace_back(first, second);
    }
    ASSERT_GT(pairs.size(), 15U);
    Random random(10);
    std::vector<Pose> poses(robot.links.size());
    for (int i = 0; i < 150; ++i) {
        Configuration q = random_configuration(robot, random);
        // Limits are where links come closest.
        for (std::size_t j = 3; j < q.size(); ++j) {
            if (random.below(3) == 0)
                q[j] = random.below(2) == 0 ? robot.variables[j].lower : robot.variables[j].upper;
        }
        forward_kinematics(robot, q, poses);
        for (const auto& [first, second] : pairs) {
            EXPECT_GT(clearance(robot, poses, first, second), 0)
                << robot.links[static_cast<std::size_t>(first)].name << ' '
                << robot.links[static_cast<std::size_t>(second)].name;
        }
    }
}

TEST(Builtin, UnknownNamesListTheKnownOnes) {
    try {
        builtin_robot("arm8");
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("arm7, mobile-arm7"), std::string::npos);
    }
}

}  // namespace
}  // namespace praxis::tamp
