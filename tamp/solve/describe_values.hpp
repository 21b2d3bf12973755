// The continuous parameters of a plan as trajectory documents hold them.
#pragma once

#include <map>
#include <string>

#include "tamp/refine/refine.hpp"
#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Those of types that Praxis knows: "pose" (x y z qx qy qz qw), "grasp" (the pose of the body in the tool's
/// frame, then the opening in metres), "configuration", "number".
std::map<std::string, TrajectoryDocument::Value> describe_values(const RefinedPlan& plan);

}  // namespace praxis::tamp
