// Robots that come with Praxis.
//
// `arm7`: an arm with seven joints and a hand with two parallel fingers, after Franka's Panda. Groups `arm`
// (tip `hand`) and `gripper`; states `home` and `ready` of the arm, `open` and `closed` of the gripper; end
// effector `hand`, whose tool frame lies between the finger tips.
//
// `mobile-arm7`: the same arm on a platform that moves in the plane; x, y and theta come first among
// the variables. Also groups `base`, and `base_arm` for motions of both; state `home` of the base, `home` and
// `ready` of `base_arm` with the platform at the origin.
//
// The files that they are made of are in tamp/robots/models.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

std::vector<std::string> builtin_robot_names();

/// The robot of this name at the world's origin. Throws std::invalid_argument, listing the names, if there is
/// none.
Robot builtin_robot(std::string_view name, const CoverOptions& cover = {});

}  // namespace praxis::tamp
