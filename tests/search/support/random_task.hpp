// Small random tasks with every kind of formula, effect and axiom, for comparing two readings of the
// semantics.
#pragma once

#include <cstdint>

#include "search/plan.hpp"

namespace praxis::test {

struct RandomTask {
    LiftedTask task;
    Plan plan;
};

/// The same seed gives the same task. Axioms are stratified by construction.
RandomTask random_task(std::uint32_t seed);

}  // namespace praxis::test
