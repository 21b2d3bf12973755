// Checks a refined plan as a whole: that its actions lead to the goal, and that its motion is what they say.
//
// 1. On the task as it is written, with what the streams certify, the independent validator of plans executes
//    every step (`search/validate.hpp`).
// 2. At the end of every action the document agrees with the symbolic state: a body that an atom relates to a
//    pose stands there, and one that an atom relates to a grasp is held in that way. (Atoms count that
//    actions change and whose first two arguments are these: `(at BODY POSE)`, `(holding BODY GRASP)`.)
// 3. Where a stream certifies an atom of a body, a pose and a region, the body stands in that region there;
//    and poses that the scene names are those.
//
// `trajectory_validator.hpp` checks the motion itself.
#pragma once

#include <string>

#include "tamp/refine/refine.hpp"
#include "tamp/report/trajectory_document.hpp"
#include "tamp/scenes/scene.hpp"

namespace praxis::tamp {

struct RefinementVerdict {
    bool valid = true;
    std::string reason = {};  ///< one sentence; empty if valid
};

/// The first of the three checks alone.
RefinementVerdict validate_symbolically(const StreamTask& task, const RefinedPlan& plan);

/// All three. `tolerance`: of poses, metres and radians. Throws std::invalid_argument if the document is not
/// in order by itself (`check_document`).
RefinementVerdict validate_refinement(const StreamTask& task, const RefinedPlan& plan, const Scene& scene,
                                      const TrajectoryDocument& document, double tolerance = 1e-5);

}  // namespace praxis::tamp
