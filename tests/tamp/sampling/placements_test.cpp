#include "tamp/sampling/placements.hpp"

#include <gtest/gtest.h>

#include <set>

namespace praxis::tamp {
namespace {

BodyModel stick() {
    return {.name = "stick",
            .shapes = {{pose_from_rpy({0.01, 0, 0}, Vector3::Zero()), Box{{0.04, 0.1, 0.2}}}}};
}

World table() {
    BodyModel top{.name = "table", .shapes = {{Pose::Identity(), Box{{1, 1, 0.1}}}}};
    return World().with_body(std::make_shared<const BodyModel>(top), pose_from_rpy({2, 1, 0.5}, {0, 0, 0.7}));
}

const Area kTray{
    .name = "tray", .body = 0, .pose = pose_from_rpy({0.1, 0, 0.05}, Vector3::Zero()), .size = {0.3, 0.2}};

TEST(Placements, AllStandInTheRegion) {
    const World world = table();
    std::set<std::array<double, 3>> places;
    std::uint32_t found = 0;
    for (std::uint32_t i = 0; i < 100; ++i) {
        const std::optional<Pose> pose = make_placement(stick(), world, kTray, i);
        if (!pose) continue;
        ++found;
        EXPECT_TRUE(stands_in(stick(), *pose, world, kTray)) << i;
        places.insert({pose->translation().x(), pose->translation().y(), pose->linear()(0, 0)});
    }
    EXPECT_EQ(found, 64U);
    EXPECT_EQ(places.size(), found);
}

TEST(Placements, TheFirstIsInTheMiddle) {
    const World world = table();
    const Pose pose = make_placement(stick(), world, kTray, 0).value();
    const Vector3 middle = area_pose(world, kTray).inverse() * (pose * Vector3(0.01, 0, -0.1));
    EXPECT_LT((middle - Vector3(0, 0, kPlacementGap)).norm(), 1e-12);
}

TEST(Placements, WhatDoesNotFitIsNotPlaced) {
    const World world = table();
    Area narrow = kTray;
    narrow.size[1] = 0.05;
    // Only with its long side along x.
    for (std::uint32_t i = 0; i < 64; ++i) {
        const std::optional<Pose> pose = make_placement(stick(), world, narrow, i);
        EXPECT_EQ(pose.has_value(), i / 16 == 1) << i;
    }
    narrow.size[0] = 0.09;
    for (std::uint32_t i = 0; i < 64; ++i) EXPECT_FALSE(make_placement(stick(), world, narrow, i));
}

TEST(Placements, TiltedOrHighOrOutsideIsNotStanding) {
    const World world = table();
    const Pose pose = make_placement(stick(), world, kTray, 0).value();
    EXPECT_FALSE(stands_in(stick(), pose * pose_from_rpy(Vector3::Zero(), {0.1, 0, 0}), world, kTray));
    EXPECT_FALSE(stands_in(stick(), pose * pose_from_rpy({0, 0, 0.02}, Vector3::Zero()), world, kTray));
    EXPECT_FALSE(stands_in(stick(), pose * pose_from_rpy({0.2, 0, 0}, Vector3::Zero()), world, kTray));
}

}  // namespace
}  // namespace praxis::tamp
