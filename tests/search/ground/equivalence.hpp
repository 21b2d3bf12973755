// Whether a ground task means what the lifted one means.
#pragma once

#include <cstddef>
#include <string>

#include "parser/task.hpp"

namespace praxis::test {

struct Equivalence {
    std::string difference;  ///< empty: none was found

    // What kind of task it was.
    std::size_t states = 0;  ///< of the lifted task, up to the bound
    bool complete = false;   ///< all states were looked at
    bool solvable = false;   ///< a goal was reached
    bool proved_unsolvable = false;
    bool derived = false;       ///< the ground task has axioms
    bool conditional = false;   ///< ... conditional effects
    bool multi_valued = false;  ///< ... a variable of three values or more
    bool shadowed = false;      ///< ... an atom in two variables
    bool mutex_groups = false;  ///< ... groups across variables
};

/// Grounds with and without pruning and compares: state by state the applicable actions, their costs and
/// successors, the atoms that hold, the goal; the mutex groups; length of the shortest plan and cheapest
/// cost. At most `most` states are expanded. Where grounding proves that there is no plan, the rest is
/// compared without the goal.
Equivalence compare(const LiftedTask& task, std::size_t most);

}  // namespace praxis::test
