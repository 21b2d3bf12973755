// The goal, conjunct by conjunct: how many do not hold is what guides the search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "search/lifted/actions.hpp"
#include "search/lifted/query_solver.hpp"

namespace praxis::lifted {

class Goal {
  public:
    /// Compiles the goal; `finish` is to be called once the database is finished.
    Goal(Database& database, QuerySolver& solver);
    void finish();

    /// A conjunct over what never changes does not hold, or two contradict each other; the counts below then
    /// mean nothing.
    bool impossible() const { return impossible_; }
    /// All conjuncts are literals over fluent predicates: `literals_missing` says all.
    bool simple() const { return conditions_.empty(); }

    /// How many literals do not hold in a state, and after a change of a state.
    std::uint32_t literals_missing(std::span<const AtomNumber> state) const;
    std::uint32_t literals_missing(std::uint32_t before, const Change& change) const;
    /// How many of the other conjuncts do not hold in the database's present state.
    std::uint32_t conditions_missing();
    const std::vector<AtomNumber>& positive_literals() const { return wanted_; }
    bool positive_literals_hold() const {
        return std::ranges::all_of(wanted_, [&](AtomNumber atom) { return database_.holds(atom); });
    }
    std::size_t size() const { return literals_.size() + conditions_.size(); }

  private:
    struct Literal {
        PredicateNumber predicate;
        std::vector<ObjectNumber> arguments;
        bool negated;
    };
    int sign(AtomNumber atom) const { return atom < signs_.size() ? signs_[atom] : 0; }

    Database& database_;
    QuerySolver& solver_;
    bool impossible_ = false;
    std::vector<Literal> literals_;
    std::vector<AtomNumber> wanted_;
    std::vector<std::int8_t> signs_;  ///< by atom: 1 wanted, -1 not wanted
    std::vector<std::vector<Query>> conditions_;
    std::vector<ObjectNumber> binding_;
};

}  // namespace praxis::lifted
