#include "tamp/geometry/point_triangle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tamp/collision/random_pose.hpp"

namespace praxis::tamp {
namespace {

/// By looking at many points of the triangle: never less than the distance, and more by their spacing at most.
double sampled_distance(const Vector3& point, const Vector3& a, const Vector3& b, const Vector3& c, int count) {
    double least = 1e9;
    for (int i = 0; i <= count; ++i) {
        for (int j = 0; i + j <= count; ++j) {
            const Vector3 sample = a + (b - a) * i / count + (c - a) * j / count;
            least = std::min(least, (sample - point).norm());
        }
    }
    return least;
}

TEST(PointTriangle, DistancesAreThoseToTheNearestOfManyPoints) {
    Random random(1);
    constexpr int kCount = 60;
    for (int i = 0; i < 200; ++i) {
        const Vector3 a = random_pose(random, 1).translation();
        const Vector3 b = random_pose(random, 1).translation();
        const Vector3 c = random_pose(random, 1).translation();
        const Vector3 point = random_pose(random, 1).translation();
        const double distance = std::sqrt(squared_distance(point, a, b, c));
        const double sampled = sampled_distance(point, a, b, c, kCount);
        const double spacing = ((b - a).norm() + (c - a).norm()) / kCount;
        EXPECT_LE(distance, sampled + 1e-12);
        EXPECT_GE(distance, sampled - spacing);
    }
}

TEST(PointTriangle, FlatTrianglesAreSegmentsAndPoints) {
    const Vector3 a = {0, 0, 0};
    const Vector3 b = {1, 0, 0};
    const Vector3 c = {3, 0, 0};
    EXPECT_DOUBLE_EQ(squared_distance({2, 1, 0}, a, b, c), 1);
    EXPECT_DOUBLE_EQ(squared_distance({4, 0, 0}, a, b, c), 1);
    EXPECT_DOUBLE_EQ(squared_distance({0, 2, 0}, a, a, a), 4);
}

}  // namespace
}  // namespace praxis::tamp
