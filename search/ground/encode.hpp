// From propositions to finite-domain variables.
#pragma once

#include <memory>

#include "search/budget.hpp"
#include "search/ground/invariants.hpp"
#include "search/ground/proposition_task.hpp"
#include "search/ground/relations.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis::grounding {

/// Chooses variables among the mutex groups (greedily the largest first), encodes operators, axioms and goal,
/// and, if asked, leaves out variables that cannot matter for the goal. Throws UnsupportedError for costs too
/// large. If the budget runs out, the result is incomplete.
FiniteDomainTask encode(const LiftedTask& lifted, const PropositionTask& task,
                        const MutexGroups& mutex_groups, const Relations& relations,
                        const std::vector<RelationId>& actions, bool prune_irrelevant, const Budget& budget);

}  // namespace praxis::grounding
