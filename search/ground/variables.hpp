// Which atom is which value of which variable.
#pragma once

#include <vector>

#include "search/ground/invariants.hpp"
#include "search/ground/proposition_task.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis::grounding {

/// A choice of variables. Values of a group variable are its atoms, then perhaps "none of those"; of an atom
/// with a variable of its own: 0 true, 1 false.
///
/// An atom of a larger group whose negation is needed has a *shadow*, a variable of its own besides the
/// group's, so that "not this value" is a fact like any other instead of a disjunction that multiplies
/// operators.
struct Variables {
    static constexpr std::int32_t kNone = -1;

    std::vector<Fact> fact_of;  ///< by atom: the fact that stands for it; variable kNone if it has none
    std::vector<std::int32_t> shadow_of;  ///< by atom: variable, or kNone
    PackedLists<AtomId> members;          ///< by variable: its atoms, in value order
    std::vector<bool> has_none;   ///< by variable: the last value is "none of those" (or "not the atom")
    std::vector<bool> is_shadow;  ///< by variable

    std::int32_t size_of(std::size_t variable) const {
        return static_cast<std::int32_t>(members[variable].size()) + (has_none[variable] ? 1 : 0);
    }
    std::int32_t none_of(std::size_t variable) const {
        return static_cast<std::int32_t>(members[variable].size());
    }
    std::size_t count() const { return has_none.size(); }
};

/// A delete of operator `o` after which, whenever it happens, an add gives the variable another value.
bool overridden(const PropositionTask& task, const Variables& variables, std::size_t o,
                PropositionEffect deletion);

Variables choose_variables(const PropositionTask& task, const PackedLists<AtomId>& groups);

}  // namespace praxis::grounding
