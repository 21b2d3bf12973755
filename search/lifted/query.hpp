// A condition as a database query: a conjunction whose variables are to be given values.
//
// Conditions of the task are compiled (`QueryCompiler`) to alternatives, each a query: positive atoms over
// views, which are joined; tests (different, equal, atom absent), run as soon as their variables have values;
// and checks, nested conditions that are looked at when everything else holds: a universal condition is a
// check that no counterexample has a solution. Equations are solved at compile time.
#pragma once

#include <cstdint>
#include <vector>

#include "search/lifted/database.hpp"

namespace praxis::lifted {

/// A variable of the scope, or ~object.
using TermCode = std::int32_t;

struct Query {
    struct Atom {
        ViewNumber view;
        std::uint32_t begin, end;  ///< of `slots`: the variables of the view's columns
    };
    struct Test {
        enum class Kind : std::uint8_t { unequal, equal, absent };
        Kind kind;
        TermCode left = 0, right = 0;      ///< comparisons
        PredicateNumber predicate = 0;     ///< absent
        std::uint32_t begin = 0, end = 0;  ///< absent: of `terms`
    };
    /// Some alternative has a solution, or (not wanted) none has.
    struct Check {
        bool wanted;
        std::vector<Query> alternatives;
    };
    struct Copy {
        std::uint32_t variable;
        TermCode source;
    };

    std::vector<Atom> atoms;
    std::vector<std::uint32_t> slots;
    std::vector<Test> tests;
    std::vector<TermCode> terms;
    std::vector<std::uint32_t> tests_begin;  ///< by variable, and one more: of `tests_of`
    std::vector<std::uint32_t> tests_of;
    std::vector<Check> checks;
    std::vector<Copy> copies;               ///< variables whose values follow from equations
    std::vector<std::uint32_t> own;         ///< variables to be given values; all others have theirs
    std::vector<std::uint8_t> distinguish;  ///< by variable: solutions that agree on these are the same
    std::uint32_t distinguish_count = 0;

    std::vector<std::uint32_t> order;      ///< scratch: of the atoms, those already joined first
    std::vector<ObjectNumber> saved;       ///< scratch: outer values of `own`
    std::vector<ObjectNumber> tuple;       ///< scratch: arguments of an absent atom
    std::vector<std::uint32_t> new_slots;  ///< scratch: a stack of columns that bind variables
};

}  // namespace praxis::lifted
