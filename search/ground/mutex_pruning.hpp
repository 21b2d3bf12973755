// What mutex groups rule out: operators that require two atoms of a group, and what only they made reachable.
#pragma once

#include "search/ground/invariants.hpp"
#include "search/ground/proposition_task.hpp"

namespace praxis::grounding {

/// Removes operators, conditional effects and axioms whose conditions contain two atoms of one group or an
/// atom that cannot come true (`PropositionTask::never` then marks such atoms), deletes of atoms that are
/// surely false, and negative literals of atoms that are never true. The groups lose the atoms that never
/// come true.
void prune_with_mutexes(PropositionTask& task, MutexGroups& groups);

}  // namespace praxis::grounding
