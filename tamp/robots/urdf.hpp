// Robots out of URDF files (http://wiki.ros.org/urdf/XML), read by urdfdom.
//
// What URDF leaves open is settled so. Links and joints are numbered depth first, in the order of the file.
// A planar joint becomes three: NAME/x and NAME/y slide along two axes that span the plane (those of the
// joint where its normal is z), NAME/theta turns about the normal; two links without shapes lie between.
// Floating joints are refused. A mimic joint shares the variable of its master, whose limits count. A limit
// of velocity that is missing or 0 means `kDefaultVelocity`; soft limits of a safety controller narrow those
// of the joint. URDF knows no limits of acceleration: see `RobotOptions::limits` and
// `kDefaultAccelerationTime`. It knows no capsules either: a cylinder with balls of its radius at both ends
// is one.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

/// The robot with its shapes, their covers, and neighbouring links allowed to touch; without groups, states
/// and end effectors, which are for `read_robot` (read_robot.hpp). Throws InputError naming file, element and
/// mend: for broken XML, numbers that are not finite, sizes that are not positive, links that make no tree,
/// meshes that cannot be read, and more than a robot may have (robot.hpp).
Robot read_urdf(const std::string& file, const RobotOptions& options = {});

/// The same from text; meshes are looked for beside the file that the source is named after.
Robot parse_urdf(const Source& source, const RobotOptions& options = {});

}  // namespace praxis::tamp
