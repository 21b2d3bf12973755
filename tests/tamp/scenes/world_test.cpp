#include "tamp/scenes/world.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace praxis::tamp {
namespace {

std::shared_ptr<const BodyModel> cube(const std::string& name) {
    BodyModel model;
    model.name = name;
    model.shapes.push_back({Pose::Identity(), Box{{0.1, 0.1, 0.1}}});
    return std::make_shared<const BodyModel>(std::move(model));
}

TEST(World, SnapshotsKeepWhatTheyWere) {
    const World empty;
    const World one = empty.with_body(cube("a"), Pose::Identity());
    const World moved = one.with_pose(0, pose_from_rpy({1, 0, 0}, Vector3::Zero()));
    EXPECT_EQ(empty.size(), 0U);
    EXPECT_EQ(one[0].pose.translation().x(), 0);
    EXPECT_EQ(moved[0].pose.translation().x(), 1);
    EXPECT_EQ(one[0].model, moved[0].model);
    EXPECT_EQ(moved.find("a"), 0);
    EXPECT_EQ(moved.find("b"), -1);
}

TEST(World, AttachedBodiesAreReleasedByAPose) {
    const World one = World().with_body(cube("a"), Pose::Identity());
    const World held = one.with_attached(0, {.link = 3});
    ASSERT_TRUE(held[0].attachment);
    EXPECT_EQ(held[0].attachment->link, 3);
    EXPECT_FALSE(held.with_pose(0, Pose::Identity())[0].attachment);
}

TEST(World, AllowedContactsHaveNoOrder) {
    const Participant link{Participant::Kind::link, 2};
    const Participant body{Participant::Kind::body, 0};
    const World world = World().with_body(cube("a"), Pose::Identity()).with_allowed(body, link);
    EXPECT_TRUE(world.allowed(link, body));
    EXPECT_TRUE(world.allowed(body, link));
    EXPECT_FALSE(world.allowed(body, {Participant::Kind::link, 1}));
}

TEST(World, WrongUseIsRefused) {
    const World one = World().with_body(cube("a"), Pose::Identity());
    Pose broken = Pose::Identity();
    broken.translation().z() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(one.with_body(cube("a"), Pose::Identity()), std::invalid_argument);
    EXPECT_THROW(one.with_pose(1, Pose::Identity()), std::invalid_argument);
    EXPECT_THROW(one.with_pose(0, broken), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
