// Groups, states, end effectors and allowed collisions out of SRDF files
// (https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html).
//
// How its elements are read. `group`: the variables of its joints (a planar joint has three), of the joints
// above its links, of its chains and subgroups; mimic joints add none. The tip is that of the last chain, or
// of the last subgroup that has one, or the link below the last joint where the joints follow one another;
// the groups of end effectors have none. A group without variables is only a set of links. `group_state`:
// joints that it leaves out stand at zero. `end_effector`: bodies are attached to `parent_link`; without
// `parent_group` the group with that tip moves it. Its gripper is open and closed in the states `open` and
// `close` or `closed` of its group, else at the upper and lower limits. Praxis reads one element more,
//
//     <end_effector ...> <tool xyz="0 0 0.1034" rpy="0 0 0" max_opening="0.08"/> </end_effector>
//
// the tool frame in `parent_link` (z out of the hand, y from finger to finger) and the distance between the
// fingers when open; without it, that link's own frame and the way of the sliding fingers. `virtual_joint`:
// `fixed` changes nothing, `planar` puts the robot on a mobile base (`NAME/x`, `NAME/y`, `NAME/theta`),
// `floating` is refused. `disable_collisions`, `disable_default_collisions`, `enable_collisions`: as in
// MoveIt; neighbours in the tree may touch in any case. What else a file has (sphere approximations, passive
// joints) is passed over.
#pragma once

#include "parser/source.hpp"
#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Adds to a robot what the file says. Returns whether it says which links may touch. Throws InputError
/// naming element and mend, for unknown links, joints and groups too.
bool apply_srdf(Robot& robot, const Source& source);

}  // namespace praxis::tamp
