// When to be where along a path: trajectories under limits of velocity and acceleration.
//
// The trajectory follows the path's segments and rounds its corners by parabolas, along which every
// variable's acceleration is constant (Kunz and Stilman, Turning paths into trajectories using parabolic
// blends, 2011). A blend leaves the path by at most `max_deviation` and uses at most half of each segment;
// with `max_deviation` 0, or where a blend would touch something, the motion stops at the corner. Speeds at
// the corners are the greatest that the limits allow, by a pass forwards and one backwards over the path, and
// between corners every segment is run as fast as its slowest variable allows: full acceleration, cruise,
// full deceleration. The cost is linear in the waypoints: 1 to 2 microseconds each.
#pragma once

#include <span>
#include <vector>

#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"
#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Greatest absolute velocity and acceleration, one number a variable of the group; all positive, finite.
struct MotionLimits {
    std::vector<double> velocity;
    std::vector<double> acceleration;
};

/// Those of the group's variables, times a scale in (0, 1]. Throws std::invalid_argument for other scales.
MotionLimits motion_limits(const Robot& robot, const Group& group, double velocity_scale = 1,
                           double acceleration_scale = 1);

struct TimingOptions {
    /// How far a corner may be cut: Euclidean over the group's variables (radians and metres).
    double max_deviation = 0.05;
    /// Looks at what the blends sweep; none: they are taken as free. Straight stretches are parts of the
    /// path and not looked at again.
    CollisionChecker* checker = nullptr;
    double step = kCheckStep;  ///< of the checks
};

/// From rest at the first waypoint to rest at the last, which are kept exactly. A path of one place gives one
/// knot. Throws std::invalid_argument if the path is empty, ragged or not finite, or the limits do not fit.
Trajectory time_parametrise(const Path& path, const MotionLimits& limits, const TimingOptions& options = {});

}  // namespace praxis::tamp
