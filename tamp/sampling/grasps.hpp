// Grasps of a parallel gripper, from the shape of the body.
//
// A gripper's *tool frame* lies between its finger tips: z points out of the hand, y from finger to finger. A
// grasp says where the body is in that frame while it is held. Bodies of one primitive are grasped by its
// shape, others by the box around all their shapes. The list is finite, without random choices and in the
// order in which the grasps are worth trying, so that "every grasp was tried" means something: it is the
// discretisation of the task.
#pragma once

#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

struct Grasp {
    Pose body_in_tool = Pose::Identity();
    double opening = 0;  ///< metres between the fingers when they touch the body
    /// Direction in which the hand comes (the tool's z), in the body's frame.
    Vector3 approach = -Vector3::UnitZ();
};

struct GraspOptions {
    bool top = true;             ///< along -z of the body
    bool side = true;            ///< along its x and y
    bool bottom = false;         ///< along +z
    int turns = 8;               ///< directions around a round body
    int places = 3;              ///< along a side that is longer than the fingers are wide
    double depth = 0.02;         ///< metres that the fingers reach over the body, at most to its middle
    double clearance = 0.004;    ///< metres left between body and open fingers, both sides together
    double finger_width = 0.02;  ///< metres, of the fingers along the tool's x
};

/// All grasps of the body that the end effector's opening allows; may be empty. Top grasps come first, and of
/// those along a side the middle one.
std::vector<Grasp> make_grasps(const BodyModel& body, const EndEffector& effector,
                               const GraspOptions& options = {});

}  // namespace praxis::tamp
