// Whole robots: a URDF file with an SRDF file beside it, or without one.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

/// Reads a robot. Without an SRDF file (an empty name), groups follow from the chains of joints, and which
/// links need no checks from sampling (derive.hpp); the latter also where the SRDF file does not say. Throws
/// InputError as `read_urdf` and `apply_srdf` do.
Robot read_robot(const std::string& urdf_file, const std::string& srdf_file = {},
                 const RobotOptions& options = {});

/// The same from texts; an SRDF text that is empty stands for none.
Robot parse_robot(const Source& urdf, const Source& srdf, const RobotOptions& options = {});

}  // namespace praxis::tamp
