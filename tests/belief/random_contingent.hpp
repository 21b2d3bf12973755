// Small random contingent tasks as PDDL text: six basic atoms, some of them unknown, with clauses of every
// kind, conditional effects on what is unknown, derived atoms, readings of actions and passive sensors.
#pragma once

#include <cstdint>

#include "tests/belief/texts.hpp"

namespace praxis::belief::test {

/// What the task may use.
struct Constructs {
    bool uncertain = true;           ///< `unknown`, clauses, open world
    bool forgetting = true;          ///< effects `(unknown (p))`
    bool derived = true;             ///< derived atoms in preconditions, conditions of sensors and goals
    bool conditional = true;         ///< `when`
    bool derived_in_effects = true;  ///< derived atoms in the conditions of effects
    bool sensors = true;             ///< passive sensors
    bool models = false;             ///< multi-valued variables, observable atoms and sensing models
};

/// The same seed gives the same task. Many have no first state, or no plan.
Texts random_contingent(std::uint64_t seed, const Constructs& constructs = {});

}  // namespace praxis::belief::test
