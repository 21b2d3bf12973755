#include "tamp/motion/path.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace praxis::tamp {
namespace {

TEST(Path, LengthIsTheSumOfItsSegments) {
    EXPECT_EQ(path_length({{1, 2}}), 0);
    EXPECT_DOUBLE_EQ(path_length({{0, 0}, {3, 4}, {3, 4}, {3, 5}}), 6);
}

/// One variable: from 1 at rest, two seconds of acceleration 1, one second at speed 2.
Trajectory two_pieces() {
    return {{{.time = 0, .positions = {1}, .velocities = {0}, .accelerations = {1}},
             {.time = 2, .positions = {3}, .velocities = {2}, .accelerations = {0}},
             {.time = 3, .positions = {5}, .velocities = {0}, .accelerations = {0}}}};
}

TEST(Trajectory, PositionsBetweenKnotsFollowFromTheAcceleration) {
    const Trajectory trajectory = two_pieces();
    EXPECT_EQ(trajectory.duration(), 3);
    EXPECT_EQ(trajectory.at(1), (Configuration{1.5}));
    EXPECT_EQ(trajectory.at(2), (Configuration{3}));
    EXPECT_EQ(trajectory.at(2.5), (Configuration{4}));
}

TEST(Trajectory, OutsideOfItsTimeItStandsStill) {
    const Trajectory trajectory = two_pieces();
    EXPECT_EQ(trajectory.at(-1), (Configuration{1}));
    EXPECT_EQ(trajectory.at(3), (Configuration{5}));
    EXPECT_EQ(trajectory.at(std::numeric_limits<double>::infinity()), (Configuration{5}));
    EXPECT_TRUE(Trajectory{}.at(0).empty());
    EXPECT_EQ(Trajectory{}.duration(), 0);
}

}  // namespace
}  // namespace praxis::tamp
