// MoveIt's YAML: a planning scene and a motion plan request, as the MotionBenchMaker data set (Chamzas et al.
// 2022) publishes them.
//
// Read are, of the scene: `world.collision_objects` with primitives (box, sphere, cylinder) and meshes given
// in place, `robot_state.joint_state`, and `allowed_collision_matrix`; of the request:
// `start_state.joint_state`, `goal_constraints` of joints, and `group_name`. Vectors may be lists or maps (x,
// y, z, w), kinds of primitives words or MoveIt's numbers. What would change the geometry and is not read
// (cones, planes, octomaps, attached objects, frames other than the world's and the root link's) is refused;
// the rest, such as planner names and tolerances, is skipped. Names of the matrix that are neither links nor
// objects are skipped, too: MoveIt keeps them for what was there once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "parser/source.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

struct MoveItProblem {
    /// As given, with the scene's allowed collisions between links added; and with a group of the request's
    /// name, made of the joints of its goal, if the robot has none of that name.
    std::shared_ptr<const Robot> robot = {};
    WorldPointer world = {};
    Configuration start = {};  ///< of the whole robot
    int group = 0;
    std::vector<Configuration> goals = {};  ///< positions of the group; any of them will do
};

/// Throws InputError with the place of what is wrong.
MoveItProblem read_moveit_problem(const std::shared_ptr<const Robot>& robot, const Source& scene,
                                  const Source& request);

}  // namespace praxis::tamp
