// Streams for domains that say where the robot is (domains/tamp/configurations): its configurations are
// values, and what moves it from one to the other is an action of its own.
//
// | stream | inputs | outputs | what it gives |
// | --- | --- | --- | --- |
// | `inverse-kinematics` | body, pose, grasp | configuration | the robot before the body: `approach` metres
// back along the hand, from where the hand can go straight to the grasp |
// | `sample-base` | body, pose | configuration | of a mobile base from which the arm may reach the body |
// | `inverse-kinematics-at` | body, pose, grasp, configuration | configuration | the same as
// `inverse-kinematics`, with the base as in the last input |
// | `plan-free-motion` | two configurations | motion | with an open, empty hand |
// | `plan-holding-motion` | two configurations, body, grasp | motion | with the body in the hand |
// | `plan-grasp`, `plan-release` | body, pose, grasp, configuration | motion | from the configuration to the
// body, and back with it; the same the other way round |
// | `test-clear` | body, pose, body, pose | - | that the two do not touch |
//
// `plan-...` have `:fluents (at)`. The function `motion-length` of a motion is the length of its paths
// (radians and metres, Euclidean over the variables that move). Values: `Configuration` (of the whole robot,
// the hand open), `ActionMotion`, and those of `pick_place_streams.hpp`.
#pragma once

#include <memory>

#include "tamp/manipulation/pick_place_streams.hpp"

namespace praxis::tamp {

/// Binds the streams and the function. A body that the scene does not know is a StreamError when it is used.
void bind_configurations(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene,
                         std::shared_ptr<const Manipulator> manipulator);

/// Sum of the lengths of a motion's paths.
double motion_length(const ActionMotion& motion);

}  // namespace praxis::tamp
