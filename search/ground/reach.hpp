// Relaxed reachability: which atoms can become true and which actions applicable if nothing were ever
// deleted.
//
// The lifted task is relaxed to a Datalog program over the relations: a rule body keeps the positive atoms,
// the (in)equalities and the negated atoms of *exact* predicates (static ones, and derived ones that depend
// on static ones only); other negations and universal conditions are dropped. Disjunctions become several
// rules while they are few, else helper relations; existential conditions become helper relations over the
// variables they share with the outside, so that witnesses do not multiply the instances. Evaluation is
// semi-naive, one tuple at a time: each rule has a join plan for each atom that may trigger it (Helmert 2009
// describes the program; the evaluation is that of modern grounders, Gebser et al. 2011). Plans are made anew
// as relations grow.
#pragma once

#include <vector>

#include "parser/task.hpp"
#include "search/budget.hpp"
#include "search/ground/condition.hpp"
#include "search/ground/relations.hpp"

namespace praxis::grounding {

/// A schema's parts in normal form.
struct NormalEffect {
    const Effect* effect = nullptr;
    Condition condition;
};
struct NormalSchema {
    Condition precondition;
    std::vector<NormalEffect> effects;
};

struct NormalTask {
    const LiftedTask* lifted = nullptr;
    std::vector<NormalSchema> schemas;
    std::vector<Condition> axioms;  ///< bodies
    Condition goal;
};

NormalTask normalise(const LiftedTask& task);

struct Reached {
    /// By predicate: never changes, and the relation is exactly what holds.
    std::vector<bool> exact;
    /// By schema: the relation of the parameter tuples of its applicable instances.
    std::vector<RelationId> actions;
    std::size_t derivations = 0;  ///< rule heads derived, new or not
    bool complete = true;         ///< false: the budget ran out
};

/// Fills the relations with everything reachable.
Reached reach(const NormalTask& task, Relations& relations);

}  // namespace praxis::grounding
