// A task without what h2 shows to be useless: operators that no plan can use, effects and axioms that never
// fire.
//
// Every plan of the task that has no operator without an effect is a plan of the pruned one. Variables,
// values, initial state and goal are the same, so that states can be exchanged. What is proved is about plans
// from the task's own initial state to its own goal. See mutex_pairs.hpp.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "search/budget.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct H2Result {
    std::shared_ptr<const FiniteDomainTask> task;  ///< the one given, if there was nothing to remove
    std::vector<OperatorId> original;              ///< by operator of `task`: the same in the task given
    bool complete = false;                         ///< to the fixpoint; otherwise there may be more to remove
    std::size_t removed_operators = 0;
    std::size_t removed_facts = 0;  ///< values that no useful state has; they are kept as values
};

/// Takes at most about `seconds`. Does nothing with tasks whose pairs take more memory than is sensible.
H2Result prune_with_h2(std::shared_ptr<const FiniteDomainTask> task, const Budget& budget, double seconds);

}  // namespace praxis
