// The ground task in propositions, before variables are made of them.
//
// Atoms are numbered: the reached tuples of each changing predicate are a block of numbers, in row order;
// auxiliary atoms, derived ones that stand for disjunctions that would multiply operators, come last. A
// *literal* is twice the atom's number, plus one if negated.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/task.hpp"
#include "search/ground/relations.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis::grounding {

using AtomId = std::uint32_t;
using Literal = std::uint32_t;

constexpr Literal positive(AtomId atom) {
    return atom * 2;
}
constexpr Literal negative(AtomId atom) {
    return atom * 2 + 1;
}
constexpr AtomId atom_of(Literal literal) {
    return literal / 2;
}
constexpr bool is_negative(Literal literal) {
    return (literal & 1) != 0;
}
constexpr Literal opposite(Literal literal) {
    return literal ^ 1;
}

/// The literal (positive: added, negative: deleted) comes true under a condition.
struct PropositionEffect {
    Literal literal;
    std::uint32_t condition;  ///< list of `conditions`; 0: none
};

/// What a ground condition comes to: a disjunction of conjunctions, each a sorted list of literals.
using Conjunction = std::vector<Literal>;
using Disjunction = std::vector<Conjunction>;

struct PropositionTask {
    /// By predicate, plus one: the first atom number. Exact predicates have none.
    std::vector<AtomId> first_atom;
    AtomId atom_count = 0;       ///< auxiliary ones included
    std::vector<bool> derived;   ///< by atom
    std::vector<bool> initial;   ///< by atom: holds at first (never for derived ones)
    std::vector<bool> constant;  ///< by atom: holds at first and is never deleted, or is always derived
    std::vector<bool> never;     ///< by atom: cannot come true; empty: not known of any

    // Operators.
    PackedLists<Literal> preconditions;      ///< sorted
    PackedLists<PropositionEffect> effects;  ///< deletes before adds
    PackedLists<Literal> conditions;         ///< conditions[0] is empty; sorted
    std::vector<std::uint32_t> schemas;      ///< by operator: the schema ...
    std::vector<Row> rows;                   ///< ... and the row of its action relation
    std::vector<Rational> costs;             ///< by operator; empty: all one

    // Axioms.
    std::vector<AtomId> heads;
    PackedLists<Literal> bodies;  ///< sorted

    bool goal_reachable = true;
    Conjunction goal;

    std::size_t operator_count() const { return schemas.size(); }
    AtomId auxiliary_begin() const { return first_atom.back(); }
};

}  // namespace praxis::grounding
