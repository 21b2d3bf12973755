// Tasks that grow while the robot acts: objects that were not known before.
//
// A *full* task has all objects that are known to exist, and names those of them that the agent has to find
// first
// (`ContingentTask::hidden_objects`). The agent plans with the visible part. When it finds something, the
// task becomes one that begins now: what is known is certain, the rest is unknown, and what the initial
// description says about the found object counts from then on.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "belief/belief.hpp"
#include "parser/contingent.hpp"

namespace praxis::belief {

/// The task without its hidden objects: no parameter, quantifier or initial atom has one of them. Goals over
/// all objects of a type are over those that are there.
std::shared_ptr<const ContingentTask> visible_part(const ContingentTask& full);

/// The full task as it stands, with `found` objects no longer hidden. `belief` is over the visible part of
/// `full`. An object that the full task does not have is added if its type is a type of the domain; the names
/// of those that could not be are appended to `refused`.
std::shared_ptr<const ContingentTask> grow(const ContingentTask& full, const Belief& belief,
                                           const std::vector<Detection>& found,
                                           std::vector<std::string>& refused);

}  // namespace praxis::belief
