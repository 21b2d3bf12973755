// Mobile bases: a planar joint as two sliding ones and a turning one.
#pragma once

#include <string>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Puts the robot on a joint in the plane: variables NAME/x, NAME/y (unlimited) and NAME/theta (continuous)
/// come first, and `frame` is the new root. Velocities and accelerations have their defaults
/// (robot_options.hpp). Throws std::invalid_argument if there is a link named `frame` already.
void add_planar_base(Robot& robot, const std::string& name, const std::string& frame);

}  // namespace praxis::tamp
