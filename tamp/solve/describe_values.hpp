// The continuous parameters of a plan as trajectory documents hold them.
#pragma once

#include <map>
#include <string>

#include "tamp/refine/refine.hpp"
#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Those of types that Praxis knows: "pose" (x y z qx qy qz qw), "grasp" (the pose of the body in the tool's
/// frame, then the opening in metres), "motion" (when the action that has it begins and ends),
/// "configuration", "number". `actions` are the plan's, in time.
std::map<std::string, TrajectoryDocument::Value> describe_values(
    const RefinedPlan& plan, const std::vector<TrajectoryDocument::Action>& actions);

}  // namespace praxis::tamp
