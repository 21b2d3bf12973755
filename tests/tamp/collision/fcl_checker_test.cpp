#include "tamp/collision/fcl_checker.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>

#include "tamp/collision/motion_order.hpp"
#include "tests/tamp/collision/random_pose.hpp"

namespace praxis::tamp {
namespace {

constexpr double kPi = std::numbers::pi;
using Kind = Participant::Kind;

constexpr Participant link(int index) {
    return {Kind::link, index};
}
constexpr Participant body(int index) {
    return {Kind::body, index};
}

/// Three links of one metre in the plane z = 0, each a ball of radius 0.1 at its end; the root is a ball too.
/// The group moves the first two joints.
std::shared_ptr<const Robot> three_links() {
    Robot robot;
    robot.name = "three-links";
    const Pose metre = pose_from_rpy({1, 0, 0}, Vector3::Zero());
    const std::vector<PlacedShape> ball_at_end = {{metre, Sphere{0.1}}};
    robot.links = {{.name = "root", .collision = {{Pose::Identity(), Sphere{0.1}}}}};
    for (int i = 0; i < 3; ++i) {
        const std::string name = std::string("link") + static_cast<char>('1' + i);
        robot.links.push_back({.name = name, .parent_joint = i, .collision = ball_at_end});
        robot.joints.push_back({.name = name,
                                .type = JointType::revolute,
                                .parent = i,
                                .child = i + 1,
                                .origin = i == 0 ? Pose::Identity() : metre,
                                .variable = i});
        robot.variables.push_back({.name = name, .lower = -kPi, .upper = kPi});
    }
    robot.groups = {{.name = "arm", .variables = {0, 1}, .tip = 2}};
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

std::shared_ptr<const BodyModel> ball(const std::string& name, double radius) {
    BodyModel model;
    model.name = name;
    model.shapes.push_back({Pose::Identity(), Sphere{radius}});
    return std::make_shared<const BodyModel>(std::move(model));
}

Pose at(double x, double y) {
    return pose_from_rpy({x, y, 0}, Vector3::Zero());
}

std::unique_ptr<CollisionChecker> checker_for(const World& world, const Configuration& rest = {0, 0, 0}) {
    return make_fcl_checker({three_links(), std::make_shared<const World>(world), 0, rest});
}

std::vector<Contact> contacts(CollisionChecker& checker, const Configuration& positions) {
    std::vector<Contact> found;
    checker.find_contacts(positions, found);
    return found;
}

TEST(FclChecker, TheCheckerNamesLinksAndBodies) {
    const World world =
        World().with_body(ball("far", 0.1), at(0, 2.9)).with_body(ball("near", 0.1), at(0, 1.1));
    const auto checker = checker_for(world);
    EXPECT_TRUE(checker->is_free(Configuration{0, 0}));
    EXPECT_FALSE(checker->is_free(Configuration{kPi / 2, 0}));
    EXPECT_EQ(contacts(*checker, {kPi / 2, 0}),
              (std::vector<Contact>{{link(1), body(1)}, {link(3), body(0)}}));
    EXPECT_TRUE(checker->fixed_contacts().empty());
}

TEST(FclChecker, LinksThatFoldBackMeetTheRoot) {
    const auto checker = checker_for(World());
    // Link 2 ends at the origin; link 3 ends beyond, at -1.
    EXPECT_EQ(contacts(*checker, {0, kPi}), (std::vector<Contact>{{link(0), link(2)}}));
}

TEST(FclChecker, WhatMayTouchIsNotChecked) {
    const World world = World().with_body(ball("a", 0.1), at(1.1, 0));
    EXPECT_FALSE(checker_for(world)->is_free(Configuration{0, 0}));
    EXPECT_TRUE(checker_for(world.with_allowed(link(1), body(0)))->is_free(Configuration{0, 0}));
    EXPECT_TRUE(checker_for(World().with_allowed(link(2), link(0)))->is_free(Configuration{0, kPi}));
    Robot robot = *three_links();
    robot.allowed_collisions = {{0, 2}};
    const auto checker = make_fcl_checker(
        {std::make_shared<const Robot>(robot), std::make_shared<const World>(), 0, Configuration{0, 0, 0}});
    EXPECT_TRUE(checker->is_free(Configuration{0, kPi}));
}

TEST(FclChecker, AttachedBodiesMoveWithTheirLink) {
    World world = World().with_body(ball("held", 0.1), at(9, 9)).with_body(ball("wall", 0.1), at(0, 3.5));
    world = world.with_attached(0, {.link = 3, .in_link = at(1.4, 0), .touching = {3}});
    const auto checker = checker_for(world);
    EXPECT_TRUE(checker->is_free(Configuration{0, 0}));
    EXPECT_EQ(contacts(*checker, {kPi / 2, 0}), (std::vector<Contact>{{body(0), body(1)}}));
}

TEST(FclChecker, OtherVariablesRestWhereTheProblemSays) {
    // Link 3 is turned back: it ends where link 1 does.
    const auto checker = checker_for(World(), {0, 0, kPi});
    EXPECT_EQ(contacts(*checker, {0, 0}), (std::vector<Contact>{{link(1), link(3)}}));
}

TEST(FclChecker, HeldBodiesMayTouchWhatTheirAttachmentNames) {
    World world = World().with_body(ball("held", 0.1), at(9, 9));
    const auto held_at = [&](double x, std::vector<int> touching) {
        return checker_for(
            world.with_attached(0, {.link = 2, .in_link = at(x, 0), .touching = std::move(touching)}));
    };
    // At the end of link 1: in contact whatever the group does? No: the group turns link 2 against link 1.
    EXPECT_EQ(contacts(*held_at(0, {}), {0, 0}), (std::vector<Contact>{{link(1), body(0)}}));
    EXPECT_TRUE(held_at(0, {1})->is_free(Configuration{0, 0}));
    // At its own link's end.
    EXPECT_TRUE(held_at(1, {})->is_free(Configuration{0, 0}));
    // At link 3, which does not move against link 2: a fixed contact unless it is allowed.
    EXPECT_EQ(held_at(2, {})->fixed_contacts(), (std::vector<Contact>{{link(3), body(0)}}));
    EXPECT_FALSE(held_at(2, {})->is_free(Configuration{1, 1}));
    EXPECT_TRUE(held_at(2, {3})->is_free(Configuration{1, 1}));
}

TEST(FclChecker, ContactsOfWhatStandsAreFixed) {
    const World world =
        World().with_body(ball("on the root", 0.1), at(-0.15, 0)).with_body(ball("away", 0.1), at(-0.3, 0));
    const auto checker = checker_for(world);
    EXPECT_EQ(checker->fixed_contacts(), (std::vector<Contact>{{link(0), body(0)}}));
    EXPECT_FALSE(checker->is_free(Configuration{0, 0}));
    EXPECT_EQ(contacts(*checker, {0, 0}), (std::vector<Contact>{{link(0), body(0)}}));
}

TEST(FclChecker, MotionsAreCheckedBetweenTheirEnds) {
    const World world = World().with_body(ball("post", 0.05), at(2.9, 0));
    const auto checker = checker_for(world);
    EXPECT_TRUE(checker->is_free(Configuration{-0.5, 0}));
    EXPECT_TRUE(checker->is_free(Configuration{0.5, 0}));
    EXPECT_FALSE(checker->is_motion_free(Configuration{-0.5, 0}, Configuration{0.5, 0}));
    EXPECT_TRUE(checker->is_motion_free(Configuration{-0.5, 0}, Configuration{-0.4, 0}));
    EXPECT_FALSE(checker->is_motion_free(Configuration{0, 0}, Configuration{0, 0}));
    EXPECT_THROW(checker->is_motion_free(Configuration{0, 0}, Configuration{0, 0}, 0), std::invalid_argument);
}

TEST(FclChecker, WrongUseIsRefused) {
    const auto world = std::make_shared<const World>();
    const auto robot = three_links();
    EXPECT_THROW(make_fcl_checker({nullptr, world, 0, {0, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(make_fcl_checker({robot, nullptr, 0, {0, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(make_fcl_checker({robot, world, 1, {0, 0, 0}}), std::invalid_argument);
    EXPECT_THROW(make_fcl_checker({robot, world, 0, {0, 0}}), std::invalid_argument);
    const World held = World().with_body(ball("a", 0.1), at(0, 0)).with_attached(0, {.link = 9});
    EXPECT_THROW(checker_for(held), std::invalid_argument);
    const auto checker = checker_for(World());
    EXPECT_THROW(checker->is_free(Configuration{0}), std::invalid_argument);
    EXPECT_THROW(checker->is_free(Configuration{0, std::nan("")}), std::invalid_argument);
}

/// Contacts found by comparing all pairs of balls, from forward kinematics alone.
std::vector<Contact> contacts_by_hand(const World& world, const Configuration& configuration) {
    const auto robot = three_links();
    std::vector<Pose> poses(robot->links.size());
    forward_kinematics(*robot, configuration, poses);
    std::vector<Vector3> centers = {poses[0].translation()};
    for (std::size_t i = 1; i < 4; ++i) centers.emplace_back(poses[i] * Vector3(1, 0, 0));
    std::vector<Contact> found;
    for (int i = 0; i < 4; ++i) {
        for (int j = i + 1; j < 4; ++j) {
            const auto a = static_cast<std::size_t>(i);
            const auto b = static_cast<std::size_t>(j);
            if (i == 2 && j == 3) continue;
            if ((centers[a] - centers[b]).norm() <= 0.2) found.push_back({link(i), link(j)});
        }
        for (int j = 0; static_cast<std::size_t>(j) < world.size(); ++j) {
            const double radius = std::get<Sphere>(world[j].model->shapes[0].shape).radius;
            if ((centers[static_cast<std::size_t>(i)] - world[j].pose.translation()).norm() <= radius + 0.1) {
                found.push_back({link(i), body(j)});
            }
        }
    }
    std::ranges::sort(found);
    return found;
}

RC_GTEST_PROP(FclChecker, FindsEveryContactOfRandomWorlds, (std::uint64_t seed)) {
    Random random(seed);
    World world;
    for (int i = 0; i < 12; ++i) {
        const Pose pose = at(uniform(random, -3, 3), uniform(random, -3, 3));
        world = world.with_body(ball("ball" + std::to_string(i), uniform(random, 0.02, 0.4)), pose);
    }
    const auto checker = checker_for(world);
    for (int i = 0; i < 20; ++i) {
        const Configuration positions = {uniform(random, -kPi, kPi), uniform(random, -kPi, kPi)};
        const std::vector<Contact> expected = contacts_by_hand(world, {positions[0], positions[1], 0});
        RC_ASSERT(contacts(*checker, positions) == expected);
        RC_ASSERT(checker->is_free(positions) == expected.empty());
    }
}

RC_GTEST_PROP(MotionOrder, VisitsEveryInnerPointOnce, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 300);
    std::vector<int> visits(count, 0);
    RC_ASSERT(coarse_to_fine(count, [&](std::size_t i) { return ++visits[i] > 0; }));
    RC_ASSERT(visits[0] == 0);
    RC_ASSERT(std::all_of(visits.begin() + 1, visits.end(), [](int number) { return number == 1; }));
}

}  // namespace
}  // namespace praxis::tamp
