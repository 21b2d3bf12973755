#include "tamp/sampling/grasps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tamp/geometry/extent.hpp"

namespace praxis::tamp {
namespace {

BodyModel body_of(Shape shape, const Pose& pose = Pose::Identity()) {
    return {.name = "body", .shapes = {{pose, std::move(shape)}}};
}

EndEffector hand() {
    return {.name = "hand", .max_opening = 0.08};
}

/// What the fingers have to close on: the body's size along the tool's y.
double width_between_fingers(const BodyModel& body, const Grasp& grasp) {
    return extent(body.shapes, grasp.body_in_tool).size().y();
}

TEST(Grasps, BoxesAreHeldBetweenParallelFaces) {
    const BodyModel box = body_of(Box{{0.04, 0.06, 0.2}});
    const std::vector<Grasp> grasps = make_grasps(box, hand());
    ASSERT_FALSE(grasps.empty());
    for (const Grasp& grasp : grasps) {
        EXPECT_NEAR(width_between_fingers(box, grasp), grasp.opening, 1e-12);
        EXPECT_LE(grasp.opening, 0.08);
        // The finger tips are inside of the body, or at its middle.
        const AxisBox around = extent(box.shapes, grasp.body_in_tool);
        EXPECT_LT(around.lower.z(), 1e-12);
        EXPECT_GT(around.upper.z(), 0);
        EXPECT_NEAR(grasp.body_in_tool.linear().determinant(), 1, 1e-12);
        EXPECT_TRUE((grasp.body_in_tool.linear() * grasp.approach).isApprox(Vector3::UnitZ(), 1e-12));
    }
    EXPECT_TRUE(grasps.front().approach.isApprox(-Vector3::UnitZ()));
}

TEST(Grasps, WhatIsTooWideIsNotGrasped) {
    EXPECT_TRUE(make_grasps(body_of(Box{{0.1, 0.1, 0.1}}), hand()).empty());
    EXPECT_TRUE(make_grasps(body_of(Cylinder{0.05, 0.2}), hand()).empty());
    // Flat: from the top the fingers close on x; from the sides on x or z.
    for (const Grasp& grasp : make_grasps(body_of(Box{{0.05, 0.3, 0.3}}), hand())) {
        EXPECT_NEAR(grasp.opening, 0.05, 1e-12);
    }
}

TEST(Grasps, LongSidesAreGraspedAtSeveralPlaces) {
    const BodyModel stick = body_of(Box{{0.04, 0.04, 0.2}});
    GraspOptions sides{.top = false};
    sides.places = 1;
    const std::size_t middle = make_grasps(stick, hand(), sides).size();
    sides.places = 5;
    std::vector<double> heights;
    for (const Grasp& grasp : make_grasps(stick, hand(), sides)) {
        heights.push_back(grasp.body_in_tool.inverse().translation().z());
    }
    EXPECT_GT(heights.size(), middle);
    EXPECT_NEAR(heights.front(), 0, 1e-12);
    EXPECT_NEAR(*std::ranges::max_element(heights), 0.09, 1e-12);
    EXPECT_NEAR(*std::ranges::min_element(heights), -0.09, 1e-12);
}

TEST(Grasps, RoundBodiesAreGraspedFromAllAround) {
    const BodyModel can = body_of(Cylinder{0.03, 0.12});
    const std::vector<Grasp> grasps = make_grasps(can, hand(), {.top = false, .turns = 4, .places = 1});
    EXPECT_EQ(grasps.size(), 8U);  // four directions, two turns of the hand
    for (const Grasp& grasp : grasps) {
        EXPECT_NEAR(grasp.opening, 0.06, 1e-12);
        EXPECT_NEAR(grasp.approach.z(), 0, 1e-12);
    }
}

TEST(Grasps, FollowTheFrameOfTheShape) {
    const Pose lying = pose_from_rpy({0.1, 0.2, 0.3}, {1.2, 0, 0.4});
    const BodyModel can = body_of(Cylinder{0.03, 0.12}, lying);
    for (const Grasp& grasp : make_grasps(can, hand(), {.side = false})) {
        EXPECT_TRUE(grasp.approach.isApprox(-lying.linear().col(2), 1e-9));
        EXPECT_TRUE((grasp.body_in_tool.linear() * grasp.approach).isApprox(Vector3::UnitZ(), 1e-9));
    }
}

TEST(Grasps, BodiesOfSeveralShapesAreGraspedByTheBoxAroundThem) {
    BodyModel mug = body_of(Box{{0.04, 0.04, 0.1}}, pose_from_rpy({0.02, 0, 0}, Vector3::Zero()));
    mug.shapes.push_back({pose_from_rpy({-0.01, 0, 0}, Vector3::Zero()), Box{{0.02, 0.01, 0.05}}});
    const std::vector<Grasp> grasps = make_grasps(mug, hand());
    ASSERT_FALSE(grasps.empty());
    for (const Grasp& grasp : grasps) {
        EXPECT_NEAR(width_between_fingers(mug, grasp), grasp.opening, 1e-12);
    }
}

}  // namespace
}  // namespace praxis::tamp
