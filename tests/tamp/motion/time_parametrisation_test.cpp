#include "tamp/motion/time_parametrisation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/tamp/support/panda.hpp"
#include "tests/tamp/support/point_checker.hpp"

namespace praxis::tamp {
namespace {

double distance_to_segment(const Configuration& at, const Configuration& a, const Configuration& b) {
    double along = 0;
    double squared = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
        along += (at[j] - a[j]) * (b[j] - a[j]);
        squared += (b[j] - a[j]) * (b[j] - a[j]);
    }
    const double share = squared == 0 ? 0 : std::clamp(along / squared, 0.0, 1.0);
    double result = 0;
    for (std::size_t j = 0; j < at.size(); ++j) {
        const double d = at[j] - a[j] - share * (b[j] - a[j]);
        result += d * d;
    }
    return std::sqrt(result);
}

double distance_to_path(const Configuration& at, const Path& path) {
    double least = distance_to_segment(at, path.front(), path.front());
    for (std::size_t i = 1; i < path.size(); ++i) {
        least = std::min(least, distance_to_segment(at, path[i - 1], path[i]));
    }
    return least;
}

/// Knots fit together, and velocities and accelerations keep to the limits.
void expect_sound(const Trajectory& trajectory, const MotionLimits& limits) {
    for (std::size_t i = 0; i < trajectory.knots.size(); ++i) {
        const Trajectory::Knot& knot = trajectory.knots[i];
        for (std::size_t j = 0; j < limits.velocity.size(); ++j) {
            EXPECT_LE(std::abs(knot.velocities[j]), limits.velocity[j] + 1e-6);
            EXPECT_LE(std::abs(knot.accelerations[j]), limits.acceleration[j] + 1e-6);
            if (i + 1 == trajectory.knots.size()) continue;
            const Trajectory::Knot& next = trajectory.knots[i + 1];
            const double t = next.time - knot.time;
            EXPECT_GT(t, 0);
            const double position =
                knot.positions[j] + t * (knot.velocities[j] + t / 2 * knot.accelerations[j]);
            EXPECT_NEAR(next.positions[j], position, 1e-9);
            EXPECT_NEAR(next.velocities[j], knot.velocities[j] + t * knot.accelerations[j], 1e-9);
        }
    }
}

TEST(TimeParametrisation, OneVariableByHand) {
    // Fast enough to cruise: 1 s up to 2, 4 units at 2, 1 s down.
    const Trajectory trapezoid = time_parametrise({{1}, {7}}, {{2}, {2}});
    ASSERT_EQ(trapezoid.knots.size(), 4U);
    EXPECT_DOUBLE_EQ(trapezoid.duration(), 4);
    EXPECT_DOUBLE_EQ(trapezoid.at(0.5)[0], 1.25);
    EXPECT_DOUBLE_EQ(trapezoid.at(2)[0], 4);
    EXPECT_DOUBLE_EQ(trapezoid.at(3.5)[0], 6.75);
    // Too short: half of it speeding up, half slowing down.
    const Trajectory triangle = time_parametrise({{0}, {-0.5}}, {{2}, {2}});
    ASSERT_EQ(triangle.knots.size(), 3U);
    EXPECT_DOUBLE_EQ(triangle.duration(), 1);
    EXPECT_DOUBLE_EQ(triangle.knots[1].velocities[0], -1);
    EXPECT_DOUBLE_EQ(triangle.at(0.5)[0], -0.25);
}

TEST(TimeParametrisation, TheSlowestVariableDecides) {
    const Trajectory trajectory = time_parametrise({{0, 0}, {6, 3}}, {{2, 1}, {2, 100}});
    EXPECT_DOUBLE_EQ(trajectory.duration(), 4);
    EXPECT_DOUBLE_EQ(trajectory.at(2)[1], 1.5);
}

TEST(TimeParametrisation, PathsOfOnePlaceTakeNoTime) {
    for (const Path& path : {Path{{1, 2}}, Path{{1, 2}, {1, 2}, {1, 2}}}) {
        const Trajectory trajectory = time_parametrise(path, {{1, 1}, {1, 1}});
        ASSERT_EQ(trajectory.knots.size(), 1U);
        EXPECT_EQ(trajectory.duration(), 0);
        EXPECT_EQ(trajectory.knots[0].positions, (Configuration{1, 2}));
    }
}

TEST(TimeParametrisation, WaypointsOnAStraightLineCostNothing) {
    const MotionLimits limits = {{1, 1}, {2, 2}};
    const double whole = time_parametrise({{0, 0}, {3, 1}}, limits).duration();
    Path path;
    for (int i = 0; i <= 10; ++i) path.push_back({0.3 * i, 0.1 * i});
    path.insert(path.begin() + 4, path[4]);
    EXPECT_NEAR(time_parametrise(path, limits, {.max_deviation = 0}).duration(), whole, 1e-9);
}

TEST(TimeParametrisation, WithoutDeviationItStopsAtCorners) {
    const MotionLimits limits = {{1, 1}, {2, 2}};
    const Trajectory stops = time_parametrise({{0, 0}, {2, 0}, {2, 2}}, limits, {.max_deviation = 0});
    EXPECT_DOUBLE_EQ(stops.duration(), 2 * time_parametrise({{0, 0}, {2, 0}}, limits).duration());
    EXPECT_EQ(stops.at(stops.duration() / 2), (Configuration{2, 0}));
}

TEST(TimeParametrisation, ARightAngleByHand) {
    // Each variable changes its speed by s within s / 2 seconds; the corner is cut by s^2 sqrt(2) / 16.
    const double cut = 0.25 * std::sqrt(2) / 16;
    const Trajectory trajectory =
        time_parametrise({{0, 0}, {2, 0}, {2, 2}}, {{1, 1}, {2, 2}}, {.max_deviation = cut});
    const Configuration corner = trajectory.at(trajectory.duration() / 2);
    EXPECT_NEAR(std::hypot(corner[0] - 2, corner[1]), cut, 1e-12);
    ASSERT_EQ(trajectory.knots.size(), 8U);
    EXPECT_NEAR(trajectory.knots[3].velocities[0], 0.5, 1e-12);
    EXPECT_NEAR(trajectory.knots[4].time - trajectory.knots[3].time, 0.25, 1e-12);
}

RC_GTEST_PROP(TimeParametrisation, KeepsLimitsEndsAndDeviation, ()) {
    const auto dimension = *rc::gen::inRange<std::size_t>(1, 8);
    const auto count = *rc::gen::inRange<std::size_t>(1, 12);
    const auto number = [](int low, int high) { return 0.01 * *rc::gen::inRange(low, high); };
    const double scale = *rc::gen::element(1.0, 0.01, 10.0);
    MotionLimits limits;
    for (std::size_t j = 0; j < dimension; ++j) {
        limits.velocity.push_back(number(10, 300));
        limits.acceleration.push_back(number(10, 1000));
    }
    Path path;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 1 && *rc::gen::inRange(0, 6) == 0) {
            path.push_back(path[i - 2]);
            continue;
        }
        Configuration waypoint;
        for (std::size_t j = 0; j < dimension; ++j) waypoint.push_back(scale * number(-300, 300));
        path.push_back(waypoint);
    }
    const double deviation = *rc::gen::element(0.0, 1e-3, 0.05, 0.5);
    const Trajectory trajectory = time_parametrise(path, limits, {.max_deviation = deviation});
    expect_sound(trajectory, limits);
    RC_ASSERT(trajectory.knots.front().positions == path.front());
    RC_ASSERT(trajectory.knots.back().positions == path.back());
    for (std::size_t j = 0; j < dimension; ++j) {
        RC_ASSERT(trajectory.knots.front().velocities[j] == 0);
        RC_ASSERT(trajectory.knots.back().velocities[j] == 0);
    }
    for (int i = 0; i <= 100; ++i) {
        const Configuration at = trajectory.at(0.01 * i * trajectory.duration());
        RC_ASSERT(distance_to_path(at, path) <= deviation + 1e-8);
    }
    double with_stops = 0;
    for (std::size_t i = 1; i < count; ++i)
        with_stops += time_parametrise({path[i - 1], path[i]}, limits).duration();
    RC_ASSERT(trajectory.duration() <= with_stops + 1e-9);
}

TEST(TimeParametrisation, BlendsThatTouchGetSmaller) {
    // A pillar in the inner side of the corner.
    const Path path = {{0, 0}, {2, 0}, {2, 2}};
    const MotionLimits limits = {{1, 1}, {2, 2}};
    const TimingOptions blind = {.max_deviation = 0.5};
    const auto blocked = [](std::span<const double> at) { return at[0] < 1.96 && at[1] > 0.04; };
    PointChecker checker(point_robot(), blocked);
    const auto touches = [&](const Trajectory& trajectory) {
        for (int i = 0; i <= 2000; ++i) {
            if (blocked(trajectory.at(trajectory.duration() * i / 2000))) return true;
        }
        return false;
    };
    const Trajectory careless = time_parametrise(path, limits, blind);
    ASSERT_TRUE(touches(careless));
    TimingOptions options = blind;
    options.checker = &checker;
    options.step = 0.01;
    const Trajectory careful = time_parametrise(path, limits, options);
    EXPECT_FALSE(touches(careful));
    expect_sound(careful, limits);
    EXPECT_GT(careful.duration(), careless.duration());
    EXPECT_LT(careful.duration(), time_parametrise(path, limits, {.max_deviation = 0}).duration());
    // Nowhere but on the path: stop.
    PointChecker narrow(point_robot(), [](std::span<const double> at) { return at[0] < 2 && at[1] > 0; });
    options.checker = &narrow;
    EXPECT_DOUBLE_EQ(time_parametrise(path, limits, options).duration(),
                     time_parametrise(path, limits, {.max_deviation = 0}).duration());
}

TEST(TimeParametrisation, LimitsOfAGroup) {
    const std::shared_ptr<const Robot> robot = panda_arm();
    const MotionLimits limits = motion_limits(*robot, robot->groups[0], 0.5, 0.1);
    EXPECT_EQ(limits.velocity, (std::vector<double>(7, 1)));
    EXPECT_EQ(limits.acceleration, (std::vector<double>(7, 0.5)));
    EXPECT_THROW(motion_limits(*robot, robot->groups[0], 0), std::invalid_argument);
    EXPECT_THROW(motion_limits(*robot, robot->groups[0], 1, 1.5), std::invalid_argument);
}

TEST(TimeParametrisation, WrongUseIsRefused) {
    const MotionLimits limits = {{1, 1}, {1, 1}};
    EXPECT_THROW(time_parametrise({}, limits), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, 0}, {1}}, limits), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, std::nan("")}}, limits), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, 0}, {1e300, 0}}, limits), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0}}, limits), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, 0}}, {{1, 0}, {1, 1}}), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, 0}}, limits, {.max_deviation = -1}), std::invalid_argument);
    EXPECT_THROW(time_parametrise({{0, 0}}, limits, {.max_deviation = std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
