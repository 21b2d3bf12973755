// From a failed skeleton to what no plan may do.
#pragma once

#include <string>
#include <vector>

#include "search/task/restrict.hpp"
#include "tamp/refine/sampler.hpp"

namespace praxis::tamp {

struct Lesson {
    Nogood nogood;
    bool definite = true;  ///< it holds of the problem; otherwise it is a guess
    std::string reason;    ///< "(pick a #g) while (at-pose b p0): ik, motion"
};

/// What the failure teaches, at least one lesson. A lesson has the events that together need the nodes that
/// explain the failure, in the states whose atoms made them needed or are to blame.
std::vector<Lesson> learn(const StreamTask& streams, const SymbolicTask& task, const Skeleton& skeleton,
                          SampleOutcome failure);

/// Only this plan's actions, all together: never definite.
Lesson exclude(const SymbolicTask& task, const Skeleton& skeleton);

}  // namespace praxis::tamp
