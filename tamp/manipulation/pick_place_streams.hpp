// The streams of domains with picking and placing (domains/tamp/pick-place), bound to a scene and a robot.
//
// | stream | inputs | outputs | what it gives |
// | --- | --- | --- | --- |
// | `sample-grasp` | body | grasp | `make_grasps`, in their order |
// | `sample-placement` | body, region | pose | `make_placement`, those that touch nothing that cannot be
// moved | | `plan-pick` | body, pose, grasp | motion | `Manipulator::pick` | | `plan-place` | body, pose,
// grasp | motion | `Manipulator::place` |
//
// The last two have `:fluents (at)`: atoms `(at BODY POSE)` say where movable bodies stand; one without such
// an atom is held or of no concern. Values: `Pose` for poses, `Grasp` for grasps, `ActionMotion` for motions.
// Pictures of failures are of type `ActionFailure`.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "tamp/manipulation/manipulator.hpp"
#include "tamp/sampling/placements.hpp"
#include "tamp/streams/stream.hpp"

namespace praxis::tamp {

struct PickPlaceScene {
    World world = {};                                     ///< as it is at first
    std::map<std::string, int, std::less<>> bodies = {};  ///< by name in PDDL
    std::map<std::string, Area, std::less<>> areas = {};  ///< by name in PDDL (regions)
    GraspOptions grasps = {};
    std::map<int, std::vector<GraspKind>> grasp_kinds = {};  ///< by body; not there: all of `grasps`
    PlacementOptions placements = {};
};

/// Binds the four streams. A body or region that the scene does not know is a StreamError when it is used.
void bind_pick_place(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene,
                     std::shared_ptr<const Manipulator> manipulator);

}  // namespace praxis::tamp
