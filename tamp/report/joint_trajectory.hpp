// Trajectory documents for ROS: YAML in the shape of trajectory_msgs/JointTrajectory.
#pragma once

#include <iosfwd>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

enum class JointTrajectoryForm {
    segments,  ///< a YAML document for each segment that moves something: its variables, time from its start
    whole,     ///< one YAML document: all variables, from the beginning to the end
};

/// Header, `joint_names`, `points` of positions, velocities, accelerations and `time_from_start` (sec,
/// nanosec). A point stands at each knot; between two of them accelerations are constant, so that controllers
/// which interpolate with cubics from positions and velocities follow exactly. Knots of the same nanosecond
/// are one point. Throws std::invalid_argument as `check_document` does.
void write_joint_trajectory(const TrajectoryDocument& document, JointTrajectoryForm form, std::ostream& out);

}  // namespace praxis::tamp
