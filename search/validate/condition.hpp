// Formulas in the shape in which they are evaluated: negation only at the leaves, implications gone, and
// every quantifier an existence question. A universal formula asks that no counterexample exists, so that its
// body's negation can be searched for like any other join.
#pragma once

#include <cstdint>
#include <vector>

#include "parser/task.hpp"

namespace praxis::validation {

struct Condition {
    enum class Kind : std::uint8_t { truth, falsity, atom, equality, all, any, exists, none };

    Kind kind = Kind::truth;
    bool positive = true;                  ///< atom, equality
    PredicateId predicate;                 ///< atom
    std::vector<Term> terms;               ///< atom, equality
    std::vector<std::uint32_t> variables;  ///< exists, none: bound in the one child
    std::vector<Condition> children;       ///< all, any, exists, none
    std::vector<std::uint32_t> free;       ///< variables that occur and are not bound inside
};

/// The formula, or its negation.
Condition compile(const Formula& formula, bool negated = false);

/// Appends the predicates that occur, with repetitions.
void collect_predicates(const Condition& condition, std::vector<PredicateId>& out);

}  // namespace praxis::validation
