// The atoms of a relaxed plan, as a path to follow: what would have to become true on the way to the goals if
// nothing were ever deleted.
//
// BFWS(f5) of Lipovetzky and Geffner (AAAI 2017) counts how many of these atoms the way to a state has made
// true. Exploration adds to the present state, round by round, all that applicable actions add, until the
// goals are there; of a task that cannot be grounded even this may be too much, so that it gives up after a
// number of actions, and there is no path then.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/lifted/actions.hpp"
#include "search/lifted/axioms.hpp"
#include "search/lifted/goal.hpp"

namespace praxis::lifted {

class RelaxedPlan {
  public:
    /// No more atoms than this are told apart.
    static constexpr std::uint32_t kMost = 64;

    RelaxedPlan(Database& database, QuerySolver& solver, Axioms& axioms, Actions& actions, Goal& goal)
        : database_(database), solver_(solver), axioms_(axioms), actions_(actions), goal_(goal) {}

    /// Makes the atoms those of a relaxed plan from the database's present state, which is changed; looks at
    /// no more than `most_actions`. Returns at how many it looked.
    std::size_t explore(std::size_t most_actions);
    /// The atoms of the relaxed plan among these, as bits.
    std::uint64_t bits(std::span<const AtomNumber> atoms) const {
        std::uint64_t result = 0;
        for (const AtomNumber atom : atoms)
            if (atom < bit_of_.size() && bit_of_[atom] < kMost) result |= std::uint64_t{1} << bit_of_[atom];
        return result;
    }

  private:
    struct Achiever {
        AtomNumber atom;
        std::uint32_t begin, end;  ///< of `support_`
    };
    void extract();

    Database& database_;
    QuerySolver& solver_;
    Axioms& axioms_;
    Actions& actions_;
    Goal& goal_;
    std::vector<Achiever> achievers_;
    std::vector<AtomNumber> support_;
    std::vector<std::uint32_t> achiever_of_;  ///< by atom: achiever + 1
    std::vector<std::uint8_t> bit_of_;        ///< by atom
};

}  // namespace praxis::lifted
