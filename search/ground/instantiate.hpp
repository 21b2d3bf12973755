// From reached tuples to ground operators and axioms.
#pragma once

#include "search/ground/proposition_task.hpp"
#include "search/ground/reach.hpp"

namespace praxis::grounding {

struct Instantiated {
    PropositionTask task;
    bool complete = true;  ///< false: the budget ran out
};

/// Throws UnsupportedError for costs that cannot be used (negative, say).
Instantiated instantiate(const NormalTask& task, const Reached& reached, Relations& relations);

}  // namespace praxis::grounding
