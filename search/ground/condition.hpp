// Conditions in negation normal form: what the grounder makes of the formulas of the lifted task.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parser/task.hpp"

namespace praxis::grounding {

/// A formula in which only literals and equalities are negated, `and`/`or` are not nested in their own kind,
/// implications are gone, and equalities between objects are decided.
struct Condition {
    enum class Kind : std::uint8_t {
        truth,
        falsity,
        literal,
        equality,
        conjunction,
        disjunction,
        exists,
        forall
    };
    Kind kind = Kind::truth;
    bool negated = false;  ///< literal, equality
    PredicateId predicate;
    std::vector<Term> terms;
    std::vector<std::uint32_t> variables;  ///< exists, forall
    std::vector<Condition> children;       ///< exists, forall: one
};

/// The normal form of a formula, or of its negation.
Condition normalise(const Formula& formula, bool negate = false);

Condition conjunction(std::vector<Condition> parts);
Condition disjunction(std::vector<Condition> parts);

/// The conjuncts of a condition: its children if it is a conjunction, itself otherwise, nothing for truth.
std::span<const Condition> conjuncts(const Condition& condition);

/// The variables that occur free, each once, in increasing order.
std::vector<std::uint32_t> free_variables(const Condition& condition);

}  // namespace praxis::grounding
