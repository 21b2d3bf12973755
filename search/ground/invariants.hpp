// Mutex groups: sets of atoms of which at most one holds in any reachable state.
//
// Candidates are lifted, as in Helmert (2009): a set of *parts*, each a predicate whose columns are matched
// with the candidate's parameters, at most one column left over (the *counted* one). For given parameter
// values, the *weight* of a state is the number of true atoms that match. A candidate is an invariant if no
// operator can raise a weight of one (or zero). Unlike the original, this is checked on the ground operators:
// each add must be balanced by a delete of an atom of the same weight that the condition says is true. That
// is cheaper than reasoning about schemas, knows all static conditions and so accepts more. An unbalanced add
// suggests extended candidates. Work is bounded by a count of steps, so that results do not depend on the
// machine, and by time.
#pragma once

#include <vector>

#include "search/budget.hpp"
#include "search/ground/proposition_task.hpp"
#include "search/ground/relations.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis::grounding {

struct MutexGroups {
    PackedLists<AtomId> groups;  ///< each with two atoms or more, exactly one of them true at first
    std::size_t candidates = 0;  ///< looked at
    std::size_t invariants = 0;  ///< accepted
    std::size_t left = 0;        ///< candidates not looked at, since the work or the time was spent
};

MutexGroups find_mutex_groups(const PropositionTask& task, const Relations& relations, const Budget& budget);

}  // namespace praxis::grounding
