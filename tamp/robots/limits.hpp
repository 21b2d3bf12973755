// Limits of variables out of a YAML file:
//
//     position:     {joint1: [-1, 1]}
//     velocity:     {joint1: 2.175}
//     acceleration: {joint1: 15, joint2: 7.5}
//
// in radians or metres, a second, and a second squared. All three parts are optional.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

/// Throw InputError naming file, line and mend. Whether the names are variables of a robot is for its reader.
MotionLimits read_limits(const std::string& file);
MotionLimits parse_limits(const Source& source);

}  // namespace praxis::tamp
