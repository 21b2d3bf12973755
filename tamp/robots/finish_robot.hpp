// What all readers of robots do at the end.
#pragma once

#include <string>

#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

/// Covers the collision shapes of every link by balls: fills `Link::balls` and `Link::bound`.
void cover_links(Robot& robot, const CoverOptions& options);

/// Sets the limits of the variables named. Throws InputError that begins with `file` for a name that no
/// variable has and for limits that make no sense.
void apply_limits(Robot& robot, const MotionLimits& limits, const std::string& file);

/// Lets every link touch its parent; sorts the pairs and drops repeated ones.
void allow_neighbours(Robot& robot);

/// `check_robot`, with an InputError that begins with `file`.
void require_valid(const Robot& robot, const std::string& file);

}  // namespace praxis::tamp
