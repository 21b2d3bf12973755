// Robots made of robots: an arm on a platform, two arms on a table.
#pragma once

#include <string>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Fixes a robot to a link of another: all that `carried` has becomes part of `carrier`, its names with
/// `prefix` in front; the root of `carried` stands at `pose` in the link. `carried.base` does not matter.
/// Throws std::invalid_argument if the link is not there, a name would be there twice, or the whole is no
/// robot any more (robot.hpp).
void mount(Robot& carrier, const Robot& carried, int link, const Pose& pose, const std::string& prefix = {});

}  // namespace praxis::tamp
