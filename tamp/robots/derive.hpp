// What can be said of a robot without being told: groups, and which links need no checks.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Makes a group of every chain of joints that does not branch, parents first. The one with most variables is
/// named `arm`, what moves below it `gripper` (if it has at most 16 variables), and the others after the
/// links at their tips. Chains of more than 16 variables are left out.
void derive_groups(Robot& robot);

/// Lets pairs of links touch that need no checks (as MoveIt's setup assistant does): links whose relative
/// pose never changes; links whose balls met in all of `samples` random configurations; and links whose balls
/// kept away from each other by more than 2 cm in all of them. Unlimited variables are drawn from a turn or
/// from 2 m.
void derive_allowed_collisions(Robot& robot, std::size_t samples, std::uint64_t seed);

}  // namespace praxis::tamp
