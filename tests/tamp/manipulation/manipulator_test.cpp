#include "tamp/manipulation/manipulator.hpp"

#include <gtest/gtest.h>

#include "tamp/collision/fcl_checker.hpp"
#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/sampling/placements.hpp"
#include "tamp/scenes/body.hpp"

namespace praxis::tamp {
namespace {

std::shared_ptr<const Robot> arm7() {
    static const auto robot = std::make_shared<const Robot>(builtin_robot("arm7"));
    return robot;
}

Configuration ready(const Robot& robot) {
    Configuration configuration = robot.zero();
    for (const NamedState& state : robot.states) {
        const Group& group = robot.groups[static_cast<std::size_t>(robot.find_group(state.group))];
        if (state.name == "ready") robot.insert(group, state.positions, configuration);
    }
    return configuration;
}

Pose at(double x, double y, double z) {
    return pose_from_rpy({x, y, z}, Vector3::Zero());
}

/// A table before the arm, and sticks of 4 x 4 x 20 cm that stand on it.
World table_with_sticks(const std::vector<std::pair<double, double>>& places) {
    World world =
        World().with_body(make_body("table", {{Pose::Identity(), Box{{0.8, 1.2, 0.1}}}}), at(0.6, 0, 0));
    for (const auto& [x, y] : places) {
        const std::string name = "stick" + std::to_string(world.size());
        world = world.with_body(make_body(name, {{Pose::Identity(), Box{{0.04, 0.04, 0.2}}}}, true),
                                at(x, y, 0.15 + kPlacementGap));
    }
    return world;
}

/// Executes the motion and checks every piece with the exact checker at a fine step.
World execute(const Manipulator& manipulator, World world, Configuration configuration,
              const ActionMotion& motion) {
    const Robot& robot = manipulator.robot();
    for (const MotionPiece& piece : motion.pieces) {
        const Group& group = robot.groups[static_cast<std::size_t>(piece.group)];
        if (!piece.path.empty()) {
            const Configuration start = robot.extract(group, configuration);
            for (std::size_t i = 0; i < start.size(); ++i) EXPECT_NEAR(start[i], piece.path.front()[i], 1e-9);
            const auto checker =
                make_fcl_checker({std::make_shared<const Robot>(robot), std::make_shared<const World>(world),
                                  piece.group, configuration});
            // The hand may touch what it is about to take or has just let go.
            if (piece.kind == TrajectoryDocument::Motion::transit ||
                piece.kind == TrajectoryDocument::Motion::transfer) {
                for (std::size_t i = 0; i + 1 < piece.path.size(); ++i) {
                    EXPECT_TRUE(checker->is_motion_free(piece.path[i], piece.path[i + 1], kCheckStep / 4));
                }
            }
            robot.insert(group, piece.path.back(), configuration);
        }
        if (piece.attach) world = world.with_attached(piece.attach->first, piece.attach->second);
        if (piece.detach) world = world.with_pose(piece.detach->first, piece.detach->second);
    }
    return world;
}

class ManipulatorTest : public testing::Test {
  protected:
    Configuration home_ = ready(*arm7());
    Manipulator manipulator_{arm7(), home_};

    /// The first grasp that works.
    std::optional<std::pair<Grasp, ActionMotion>> pick_any(const World& world, int body) {
        for (const Grasp& grasp : make_grasps(*world[body].model, manipulator_.effector())) {
            if (ActionResult result = manipulator_.pick(world, body, grasp)) {
                return std::pair(grasp, std::move(*result.motion));
            }
        }
        return std::nullopt;
    }
};

TEST_F(ManipulatorTest, TakesAStickAndPutsItElsewhere) {
    const World world = table_with_sticks({{0.5, 0.1}});
    const auto picked = pick_any(world, 1);
    ASSERT_TRUE(picked);
    const World holding = execute(manipulator_, world, manipulator_.model().home, picked->second);
    ASSERT_TRUE(holding[1].attachment);

    const Pose target = at(0.45, -0.2, 0.15 + kPlacementGap);
    const ActionResult placed = manipulator_.place(world, 1, picked->first, target);
    ASSERT_TRUE(placed) << placed.failure.message;
    Configuration home = manipulator_.model().home;
    const int gripper = manipulator_.model().gripper;
    arm7()->insert(arm7()->groups[static_cast<std::size_t>(gripper)],
                   manipulator_.model().fingers(ManipulatorModel::grip(picked->first)), home);
    const World after = execute(manipulator_, holding, home, *placed.motion);
    EXPECT_FALSE(after[1].attachment);
    EXPECT_TRUE(after[1].pose.isApprox(target, 1e-9));
}

TEST_F(ManipulatorTest, EveryMotionBeginsAndEndsAtHome) {
    const World world = table_with_sticks({{0.5, 0.1}});
    const auto picked = pick_any(world, 1);
    ASSERT_TRUE(picked);
    const auto& pieces = picked->second.pieces;
    const Configuration arm = arm7()->extract(
        arm7()->groups[static_cast<std::size_t>(manipulator_.model().arm)], manipulator_.model().home);
    EXPECT_EQ(pieces.front().path.front(), arm);
    EXPECT_EQ(pieces.back().path.back(), arm);
    EXPECT_TRUE(pieces.front().homing);
    EXPECT_TRUE(pieces.back().homing);
}

TEST_F(ManipulatorTest, SaysThatNothingReachesWhatIsFarAway) {
    const World world = table_with_sticks({{2.5, 0.1}});
    const Grasp grasp = make_grasps(*world[1].model, manipulator_.effector()).front();
    const ActionResult result = manipulator_.pick(world, 1, grasp);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.failure.reason, TrajectoryDocument::Reason::kinematics);
    EXPECT_TRUE(result.failure.bodies.empty());
    EXPECT_TRUE(result.failure.definite);
    EXPECT_NE(result.failure.message.find("stick1"), std::string::npos);
}

TEST_F(ManipulatorTest, BlamesTheBodyThatStandsInTheWay) {
    // The place is taken by another stick.
    const World world = table_with_sticks({{0.5, 0.1}, {0.45, -0.2}});
    const auto picked = pick_any(world, 1);
    ASSERT_TRUE(picked);
    const ActionResult result =
        manipulator_.place(world, 1, picked->first, at(0.45, -0.22, 0.15 + kPlacementGap));
    ASSERT_FALSE(result);
    EXPECT_EQ(result.failure.bodies, std::vector<int>{2});
    EXPECT_TRUE(result.failure.definite);
    EXPECT_FALSE(result.failure.contacts.empty());
}

TEST_F(ManipulatorTest, WhatCannotMoveIsNotBlamed) {
    World world = table_with_sticks({{0.5, 0.1}});
    world =
        world.with_body(make_body("lid", {{Pose::Identity(), Box{{0.3, 0.3, 0.02}}}}), at(0.5, 0.1, 0.27));
    GraspOptions top{.side = false};
    for (const Grasp& grasp : make_grasps(*world[1].model, manipulator_.effector(), top)) {
        const ActionResult result = manipulator_.pick(world, 1, grasp);
        ASSERT_FALSE(result);
        EXPECT_TRUE(result.failure.bodies.empty());
    }
}

TEST_F(ManipulatorTest, EqualCallsHaveEqualResults) {
    const World world = table_with_sticks({{0.5, 0.1}});
    const auto first = pick_any(world, 1);
    const auto second = pick_any(world, 1);
    ASSERT_TRUE(first && second);
    ASSERT_EQ(first->second.pieces.size(), second->second.pieces.size());
    for (std::size_t i = 0; i < first->second.pieces.size(); ++i) {
        EXPECT_EQ(first->second.pieces[i].path, second->second.pieces[i].path);
    }
}

TEST(Manipulator, AMobileBaseDrivesToWhatIsFarAway) {
    const auto robot = std::make_shared<const Robot>(builtin_robot("mobile-arm7"));
    Manipulator manipulator(robot, ready(*robot), "hand", "base");
    World world =
        World().with_body(make_body("floor", {{Pose::Identity(), Box{{8, 8, 0.1}}}}), at(0, 0, -0.06));
    world = world.with_body(make_body("table", {{Pose::Identity(), Box{{0.5, 0.5, 0.4}}}}), at(3, 1, 0.2));
    world = world.with_body(make_body("stick", {{Pose::Identity(), Box{{0.04, 0.04, 0.2}}}}, true),
                            at(2.9, 1, 0.5 + kPlacementGap));
    std::string why;
    for (const Grasp& grasp : make_grasps(*world[2].model, manipulator.effector())) {
        const ActionResult result = manipulator.pick(world, 2, grasp);
        if (result) {
            EXPECT_EQ(result.motion->pieces.front().kind, TrajectoryDocument::Motion::base);
            EXPECT_EQ(result.motion->pieces.back().kind, TrajectoryDocument::Motion::base);
            execute(manipulator, world, manipulator.model().home, *result.motion);
            return;
        }
        why = result.failure.message;
    }
    FAIL() << why;
}

}  // namespace
}  // namespace praxis::tamp
