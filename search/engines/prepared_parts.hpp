// What PreparedTask holds.
#pragma once

#include <memory>

#include "search/engines/search.hpp"
#include "search/state/axiom_evaluator.hpp"
#include "search/state/state_packer.hpp"
#include "search/state/successor_generator.hpp"
#include "search/state/transitions.hpp"

namespace praxis {

struct PreparedTask::Parts {
    Parts(std::shared_ptr<const FiniteDomainTask> the_task, const Budget& budget)
        : task(std::move(the_task)),
          packer(*task),
          transitions(*task, packer),
          axioms(*task),
          generator(*task, budget),
          stop(budget.exhausted()) {}

    std::shared_ptr<const FiniteDomainTask> task;
    StatePacker packer;
    Transitions transitions;
    AxiomEvaluator axioms;
    SuccessorGenerator generator;
    Stop stop;  ///< not none: the budget ran out, and the generator may be incomplete
};

}  // namespace praxis
