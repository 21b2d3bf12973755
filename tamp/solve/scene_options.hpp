// The `stream_options` of a scene: what its streams try, and how much of it.
//
// | option | meaning | default |
// | --- | --- | --- |
// | `effector` | name of the end effector that grasps | the robot's first |
// | `base` | group of the mobile base; `none`: it stands | `base`, if the robot has such a group |
// | `approach`, `lift` | metres before and after a body is touched, and that it is lifted | 0.1, 0.05 |
// | `arm_configurations` | tried for one grasp (and base pose) | 6 |
// | `base_poses` | tried for one grasp | 24 |
// | `base_nearest`, `base_furthest` | metres from the base to a body that it reaches for | 0.35, 0.75 |
// | `plan_time` | seconds for one motion | 0.5 |
// | `grasp_turns`, `grasp_places` | directions around a round body; places along a long side | 8, 3 |
// | `grasp_depth`, `grasp_clearance` | metres that fingers reach over a body; that are left beside it | 0.02,
// 0.004 | | `placements` | tried of a body in a region | 64 | | `placement_margin` | metres from a region's
// border | 0.002 |
#pragma once

#include <string>

#include "tamp/manipulation/manipulator.hpp"
#include "tamp/sampling/placements.hpp"
#include "tamp/scenes/scene.hpp"

namespace praxis::tamp {

struct SceneOptions {
    std::string effector = {};  ///< empty: the robot's first
    std::string base = {};      ///< group; empty: the robot stands
    ManipulatorOptions manipulator = {};
    GraspOptions grasps = {};
    PlacementOptions placements = {};
};

/// Throws InputError for options that are not known ("did you mean ...?") and values that make no sense.
SceneOptions scene_options(const Scene& scene);

}  // namespace praxis::tamp
