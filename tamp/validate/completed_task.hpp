// A refined plan as an ordinary one: its values become objects of the task, and what streams certify of them
// becomes part of the initial state. Shares nothing with the planner.
#pragma once

#include <stdexcept>
#include <vector>

#include "search/plan.hpp"
#include "tamp/refine/refine.hpp"

namespace praxis::tamp {

struct CompletedTask {
    LiftedTask task;  ///< without costs: those of values are not known to PDDL
    Plan plan;
    std::vector<Value> values;  ///< by object; without content: one that has only its name
    /// What streams certify, in an order in which every stream's domain holds before.
    std::vector<std::pair<PredicateId, std::vector<ObjectId>>> certified;
};

/// The plan does not follow from the task and what it says of the streams; the message says where.
class IncompletePlan : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws IncompletePlan for facts whose stream's domain does not hold, for values that no stream has made,
/// and for steps that are none of the task's actions.
CompletedTask complete(const StreamTask& streams, const RefinedPlan& plan);

}  // namespace praxis::tamp
