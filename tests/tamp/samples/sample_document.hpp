// An arm on a floor that moves a can from a table into a shelf, made by hand.
#pragma once

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Variables: yaw, shoulder, elbow, wrist, finger. The tool points down at the end of two links of 0.45 m.
Robot sample_robot();

/// Configuration with the tool at a point (x, y, z), pointing down. It must be within reach.
Configuration sample_reach(const Vector3& point, double finger);

/// Two actions (pick, place) of four motions each, and three failed attempts.
TrajectoryDocument sample_document();

}  // namespace praxis::tamp
