#include "tamp/sampling/base_poses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace praxis::tamp {
namespace {

TEST(BasePoses, StandOnRingsAndLookInwards) {
    const Vector3 around(1, 2, 0.7);
    const std::vector<Configuration> poses =
        make_base_poses(around, {5, 2, 10}, {.nearest = 0.4, .furthest = 0.8});
    EXPECT_EQ(poses.size(), 24U);
    EXPECT_EQ(std::set<Configuration>(poses.begin(), poses.end()).size(), poses.size());
    for (const Configuration& pose : poses) {
        const double dx = around.x() - pose[0];
        const double dy = around.y() - pose[1];
        EXPECT_GE(std::hypot(dx, dy), 0.4);
        EXPECT_LE(std::hypot(dx, dy), 0.8);
        EXPECT_NEAR(std::cos(pose[2] - std::atan2(dy, dx)), 1, 1e-9);
        EXPECT_LE(std::abs(pose[2] - 10), std::numbers::pi + 1e-9);
    }
    // The first lies on the side that the base comes from.
    EXPECT_NEAR(poses[0][0], 1.6, 1e-9);
    EXPECT_NEAR(poses[0][1], 2, 1e-9);
}

TEST(BasePoses, WhereTheBaseIsComesFirstIfItIsNear) {
    EXPECT_EQ(make_base_poses({0, 0, 0}, {0.5, 0, 1})[0], (Configuration{0.5, 0, 1}));
    EXPECT_NE(make_base_poses({0, 0, 0}, {0.1, 0, 1})[0], (Configuration{0.1, 0, 1}));
}

}  // namespace
}  // namespace praxis::tamp
