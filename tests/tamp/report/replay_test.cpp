#include "tamp/report/replay.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>

#include "tests/tamp/samples/sample_document.hpp"

namespace praxis::tamp {
namespace {

TEST(Replay, StandsAtTheStartAndAtTheEnd) {
    const TrajectoryDocument document = sample_document();
    const Replay replay(document);
    EXPECT_EQ(replay.motion_at(-1).positions, document.start);
    EXPECT_EQ(replay.motion_at(0).positions, document.start);
    const RobotMotion end = replay.motion_at(document.duration() + 10);
    EXPECT_EQ(end.positions[0], document.segments.back().knots.back().positions[0]);
    for (const double velocity : end.velocities) EXPECT_EQ(velocity, 0);
}

TEST(Replay, MovesWithConstantAccelerationBetweenKnots) {
    const TrajectoryDocument document = sample_document();
    const Replay replay(document);
    const auto& knot = document.segments[0].knots[0];
    const RobotMotion motion = replay.motion_at(0.25);
    EXPECT_DOUBLE_EQ(motion.velocities[0], 0.25 * knot.accelerations[0]);
    EXPECT_DOUBLE_EQ(motion.positions[0], knot.positions[0] + 0.5 * 0.0625 * knot.accelerations[0]);
}

TEST(Replay, AgreesWithTheRobotOnLinks) {
    const TrajectoryDocument document = sample_document();
    const Robot robot = sample_robot();
    const Replay replay(document);
    std::vector<Pose> poses(robot.links.size());
    for (const double time : {0.0, 0.7, 2.3, 5.0}) {
        forward_kinematics(robot, replay.motion_at(time).positions, poses);
        const std::vector<Pose> links = replay.links_at(time);
        ASSERT_EQ(links.size(), poses.size());
        for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_TRUE(links[i].isApprox(poses[i], 1e-9)) << i;
    }
}

TEST(Replay, HeldBodiesFollowTheHand) {
    const TrajectoryDocument document = sample_document();
    const Replay replay(document);
    const auto can = static_cast<std::size_t>(document.find_body("can"));
    const auto hand = static_cast<std::size_t>(document.find_link("hand"));
    const double picked = document.segments[2].end;
    const double placed = document.segments[6].end;
    EXPECT_TRUE(replay.held_at(picked - 1e-6).empty());
    EXPECT_EQ(replay.held_at(picked), std::vector<std::string>{"can"});
    EXPECT_TRUE(replay.held_at(placed).empty());
    const auto in_hand = [&](double time) {
        return replay.links_at(time)[hand].inverse() * replay.bodies_at(time)[can];
    };
    EXPECT_TRUE(in_hand(picked).isApprox(in_hand((picked + placed) / 2), 1e-9));
    const Vector3 moved =
        replay.bodies_at(placed)[can].translation() - replay.bodies_at(0)[can].translation();
    EXPECT_GT(moved.norm(), 0.5);
}

RC_GTEST_PROP(Replay, IsContinuous, ()) {
    const TrajectoryDocument document = sample_document();
    const Replay replay(document);
    const double time = *rc::gen::inRange(0, 6000) / 1000.0;
    const RobotMotion now = replay.motion_at(time);
    const RobotMotion next = replay.motion_at(time + 1e-6);
    for (std::size_t v = 0; v < now.positions.size(); ++v)
        RC_ASSERT(std::abs(now.positions[v] - next.positions[v]) < 1e-4);
    const auto bodies = replay.bodies_at(time);
    const auto later = replay.bodies_at(time + 1e-6);
    for (std::size_t b = 0; b < bodies.size(); ++b) RC_ASSERT(bodies[b].isApprox(later[b], 1e-4));
}

}  // namespace
}  // namespace praxis::tamp
