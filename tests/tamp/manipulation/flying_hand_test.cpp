#include "tamp/manipulation/flying_hand.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "search/engines/random.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/scenes/body.hpp"

namespace praxis::tamp {
namespace {

const Robot& arm7() {
    static const Robot robot = builtin_robot("arm7");
    return robot;
}

Configuration random_configuration(std::uint64_t seed) {
    Random random(seed);
    Configuration configuration = arm7().zero();
    for (std::size_t v = 0; v < configuration.size(); ++v) {
        const Variable& variable = arm7().variables[v];
        const double share = static_cast<double>(random.below(1001)) / 1000;
        configuration[v] = variable.lower + share * (variable.upper - variable.lower);
    }
    return configuration;
}

RC_GTEST_PROP(FlyingHand, FliesToWhereTheArmBringsIt, (std::uint64_t seed)) {
    const EndEffector& effector = arm7().end_effectors.front();
    const FlyingHand hand = make_flying_hand(arm7(), effector, arm7().zero());
    const Configuration whole = random_configuration(seed);
    Configuration flying = hand.rest(whole);
    const Configuration at = FlyingHand::at(link_pose(arm7(), whole, effector.link));
    std::ranges::copy(at, flying.begin());
    for (const int link : effector.links) {
        const int number = hand.links[static_cast<std::size_t>(link)];
        RC_ASSERT(number >= 0);
        RC_ASSERT(link_pose(*hand.robot, flying, number).isApprox(link_pose(arm7(), whole, link), 1e-6));
    }
}

TEST(FlyingHand, TurnsUprightAndAcross) {
    for (const double pitch : {0.0, std::numbers::pi / 2, -std::numbers::pi / 2, 1.0}) {
        const Pose pose = pose_from_rpy({0.1, 0.2, 0.3}, {0.4, pitch, -0.7});
        const FlyingHand hand = make_flying_hand(arm7(), arm7().end_effectors.front(), arm7().zero());
        Configuration flying = hand.rest(arm7().zero());
        std::ranges::copy(FlyingHand::at(pose), flying.begin());
        EXPECT_TRUE(link_pose(*hand.robot, flying, hand.frame).isApprox(pose, 1e-9)) << pitch;
    }
}

/// What the hand alone touches, the arm touches with its hand: nothing is refused wrongly.
RC_GTEST_PROP(FlyingHand, NeverTouchesWhatTheArmDoesNot, (std::uint64_t seed)) {
    const EndEffector& effector = arm7().end_effectors.front();
    const auto robot = std::make_shared<const Robot>(arm7());
    const FlyingHand hand = make_flying_hand(arm7(), effector, arm7().zero());
    const Configuration whole = random_configuration(seed);
    const Pose near = link_pose(arm7(), whole, effector.link) * Eigen::Translation3d(0.03, 0, 0.1);
    const World world = World().with_body(make_body("box", {{Pose::Identity(), Box{{0.05, 0.05, 0.05}}}}), near);
    const std::vector<int> bodies = {0};
    const auto part = std::make_shared<const World>(part_of(world, bodies, hand.links));
    const auto flying = make_fcl_checker({hand.robot, part, hand.group, hand.rest(whole)});
    const int arm = arm7().find_group(effector.arm);
    const auto carried = make_fcl_checker({robot, std::make_shared<const World>(world), arm, whole});
    const Configuration positions = arm7().extract(arm7().groups[static_cast<std::size_t>(arm)], whole);
    const bool arm_is_free = carried->is_free(positions);
    if (arm_is_free) RC_ASSERT(flying->is_free(FlyingHand::at(link_pose(arm7(), whole, effector.link))));
}

TEST(BareArm, KeepsItsLinksButNotItsHand) {
    const EndEffector& effector = arm7().end_effectors.front();
    const auto bare = make_bare_arm(arm7(), effector);
    ASSERT_EQ(bare->links.size(), arm7().links.size());
    for (const int link : effector.links) EXPECT_TRUE(bare->links[static_cast<std::size_t>(link)].collision.empty());
    EXPECT_FALSE(bare->links[1].collision.empty());
}

TEST(PartOf, KeepsWhoMayTouchWhom) {
    using Kind = Participant::Kind;
    World world;
    for (const char* name : {"a", "b", "c"})
        world = world.with_body(make_body(name, {{Pose::Identity(), Sphere{0.1}}}), Pose::Identity());
    world = world.with_allowed({Kind::body, 0}, {Kind::body, 2}).with_allowed({Kind::link, 3}, {Kind::body, 2});
    const World part = part_of(world, std::vector<int>{0, 2}, std::vector<int>{-1, -1, -1, 1});
    EXPECT_EQ(part.find("c"), 1);
    EXPECT_TRUE(part.allowed({Kind::body, 0}, {Kind::body, 1}));
    EXPECT_TRUE(part.allowed({Kind::link, 1}, {Kind::body, 1}));
    EXPECT_FALSE(part.allowed({Kind::link, 1}, {Kind::body, 0}));
}

}  // namespace
}  // namespace praxis::tamp
