#include "tamp/geometry/cover.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "search/engines/random.hpp"

namespace praxis::tamp {
namespace {

double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

Vector3 unit_vector(Random& random) {
    for (;;) {
        const Vector3 point(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        if (point.norm() > 0.1 && point.norm() < 1) return point.normalized();
    }
}

bool is_covered(const std::vector<Ball>& balls, const Vector3& point) {
    return std::ranges::any_of(
        balls, [&](const Ball& ball) { return (ball.center - point).norm() <= ball.radius + 1e-12; });
}

/// Distance of a point from a solid; 0 inside.
double distance(const Box& box, const Vector3& point) {
    return (point.cwiseAbs() - box.size / 2).cwiseMax(0).norm();
}

double distance(const Cylinder& cylinder, const Vector3& point) {
    return std::hypot(std::max(0.0, std::hypot(point.x(), point.y()) - cylinder.radius),
                      std::max(0.0, std::abs(point.z()) - cylinder.length / 2));
}

double distance(const Capsule& capsule, const Vector3& point) {
    const double z = std::clamp(point.z(), -capsule.length / 2, capsule.length / 2);
    return std::max(0.0, (point - Vector3(0, 0, z)).norm() - capsule.radius);
}

Vector3 point_in(const Box& box, Random& random) {
    Vector3 point;
    for (Eigen::Index i = 0; i < 3; ++i) {
        // Often on a face, an edge or a corner: there covers fail first.
        point[i] = box.size[i] * std::clamp(uniform(random, -0.8, 0.8), -0.5, 0.5);
    }
    return point;
}

Vector3 point_in(const Cylinder& cylinder, Random& random) {
    const double radius = cylinder.radius * std::min(1.0, uniform(random, 0, 1.5));
    const double angle = uniform(random, -4, 4);
    const double z = cylinder.length * std::clamp(uniform(random, -0.8, 0.8), -0.5, 0.5);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Vector3 point_in(const Capsule& capsule, Random& random) {
    const double z = capsule.length * std::clamp(uniform(random, -0.8, 0.8), -0.5, 0.5);
    return Vector3(0, 0, z) + unit_vector(random) * capsule.radius * std::min(1.0, uniform(random, 0, 1.5));
}

/// The cover has every sampled point of the solid and keeps to its number of balls; where that number is no
/// obstacle, it sticks out no further than it should.
template <class Solid>
void check_cover(const Solid& solid, Random& random) {
    const CoverOptions options{uniform(random, 0.01, 0.05),
                               random.below(2) == 0 ? 1 + random.below(80) : 20'000};
    const std::vector<Ball> balls = cover(Shape(solid), options);
    RC_ASSERT(!balls.empty());
    RC_ASSERT(balls.size() <= options.max_balls);
    for (int i = 0; i < 300; ++i) RC_ASSERT(is_covered(balls, point_in(solid, random)));
    if (options.max_balls <= 80) return;
    for (const Ball& ball : balls) {
        for (int i = 0; i < 20; ++i) {
            RC_ASSERT(distance(solid, ball.center + unit_vector(random) * ball.radius) <=
                      options.overhang + 1e-9);
        }
    }
}

RC_GTEST_PROP(Cover, BoxesAreCoveredTightly, (std::uint32_t seed)) {
    Random random(seed);
    check_cover(Box{{uniform(random, 0, 0.4), uniform(random, 0, 0.4), uniform(random, 0, 0.4)}}, random);
}

RC_GTEST_PROP(Cover, CylindersAreCoveredTightly, (std::uint32_t seed)) {
    Random random(seed);
    check_cover(Cylinder{uniform(random, 0, 0.3), uniform(random, 0, 0.5)}, random);
}

RC_GTEST_PROP(Cover, CapsulesAreCoveredTightly, (std::uint32_t seed)) {
    Random random(seed);
    check_cover(Capsule{uniform(random, 0.001, 0.2), uniform(random, 0, 0.6)}, random);
}

RC_GTEST_PROP(Cover, SurfacesOfMeshesAreCovered, (std::uint32_t seed)) {
    Random random(seed);
    Mesh mesh{.name = "soup"};
    const std::size_t vertices = 3 + random.below(20);
    for (std::size_t i = 0; i < vertices; ++i) mesh.vertices.push_back(unit_vector(random) * 0.3);
    const std::size_t triangles = 1 + random.below(4);
    for (std::size_t i = 0; i < triangles; ++i) {
        std::array<std::uint32_t, 3> corners{};
        for (auto& corner : corners) corner = static_cast<std::uint32_t>(random.below(vertices));
        mesh.triangles.push_back(corners);
    }
    const CoverOptions options{0.02, 1 + random.below(60)};
    const std::vector<Ball> balls = cover(Shape(std::make_shared<const Mesh>(mesh)), options);
    RC_ASSERT(balls.size() <= options.max_balls);
    for (int i = 0; i < 200; ++i) {
        const auto& corners = mesh.triangles[random.below(triangles)];
        double u = uniform(random, 0, 1);
        double v = uniform(random, 0, 1);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const Vector3& origin = mesh.vertices[corners[0]];
        RC_ASSERT(is_covered(balls, origin + u * (mesh.vertices[corners[1]] - origin) +
                                        v * (mesh.vertices[corners[2]] - origin)));
    }
}

RC_GTEST_PROP(Cover, BoundingBallsAreNearlyTheSmallest, (std::uint32_t seed)) {
    Random random(seed);
    // Balls that touch a large one from the inside, two of them at opposite ends: it is the smallest.
    const Ball large{unit_vector(random), uniform(random, 0.5, 2)};
    std::vector<Ball> balls;
    const Vector3 end = unit_vector(random);
    for (int i = 0; i < 20; ++i) {
        const double radius = uniform(random, 0, 0.4);
        const Vector3 direction = i == 0 ? end : i == 1 ? Vector3(-end) : unit_vector(random);
        balls.push_back({large.center + direction * (large.radius - radius), radius});
    }
    const Ball bound = bounding_ball(balls);
    for (const Ball& ball : balls) {
        RC_ASSERT((ball.center - bound.center).norm() + ball.radius <= bound.radius + 1e-12);
    }
    RC_ASSERT(bound.radius <= large.radius * 1.05);
}

TEST(Cover, ABallAroundTwoIsTheSmallest) {
    const Ball left = {{-1, 0, 0}, 0.5};
    const Ball right = {{2, 0, 0}, 1};
    const Ball both = bounding_ball(left, right);
    EXPECT_NEAR(both.radius, 2.25, 1e-7);
    EXPECT_NEAR((both.center - Vector3(0.75, 0, 0)).norm(), 0, 1e-7);
    const Ball inner = {{2, 0.2, 0}, 0.5};
    EXPECT_EQ(bounding_ball(inner, right).radius, 1);
    EXPECT_EQ(bounding_ball(right, inner).radius, 1);
}

TEST(Cover, ASphereIsItself) {
    const std::vector<Ball> balls = cover(Shape(Sphere{0.25}));
    ASSERT_EQ(balls.size(), 1U);
    EXPECT_EQ(balls[0].radius, 0.25);
    EXPECT_EQ(bounding_ball(balls).radius, 0.25);
    EXPECT_EQ(bounding_ball({}).radius, 0);
}

TEST(Cover, PlacedShapesKeepNoBallInsideOfAnother) {
    const std::vector<PlacedShape> shapes = {{pose_from_rpy({0, 0, 1}, {0, 0, 0}), Sphere{0.1}},
                                             {pose_from_rpy({0, 0, 1.1}, {0, 0, 0}), Sphere{0.5}},
                                             {Pose::Identity(), Sphere{0.2}}};
    const std::vector<Ball> balls = cover(shapes);
    ASSERT_EQ(balls.size(), 2U);
    EXPECT_EQ(balls[0].radius, 0.5);
    EXPECT_EQ(balls[0].center.z(), 1.1);
    EXPECT_EQ(balls[1].radius, 0.2);
}

TEST(Cover, NonsenseIsRefused) {
    EXPECT_THROW(cover(Shape(Sphere{-1})), std::invalid_argument);
    EXPECT_THROW(cover(Shape(Box{{1, std::nan(""), 1}})), std::invalid_argument);
    EXPECT_THROW(cover(Shape(Cylinder{1, HUGE_VAL})), std::invalid_argument);
    EXPECT_THROW(cover(Shape(Capsule{1, -1})), std::invalid_argument);
    EXPECT_THROW(cover(Shape(std::make_shared<const Mesh>())), std::invalid_argument);
    EXPECT_THROW(cover(Shape(std::shared_ptr<const OccupancyMap>())), std::invalid_argument);
    EXPECT_THROW(cover(Shape(Sphere{1}), {0, 8}), std::invalid_argument);
    EXPECT_THROW(cover(Shape(Sphere{1}), {0.01, 0}), std::invalid_argument);
    const Mesh broken{"broken", {Vector3::Zero()}, {{0, 0, 7}}};
    EXPECT_THROW(cover(Shape(std::make_shared<const Mesh>(broken))), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
