// First states of the world: those that a file names, and those that the initial description allows.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "belief/belief_task.hpp"
#include "search/engines/random.hpp"

namespace praxis::belief {

/// A state of the physical task, by variable; derived variables at their default.
using WorldState = std::vector<std::int32_t>;

/// Hidden world number `i` of the source. Uncertain atoms that it does not mention are false.
WorldState hidden_world(const BeliefTask& task, std::size_t i);

/// A random first state that the initial description allows; nothing if none is found. Of "exactly one" each
/// is equally likely, as far as the other clauses let it.
std::optional<WorldState> sample_world(const BeliefTask& task, Random& random);

/// All joint first values of some variables that the clauses among them allow: rows in the order of the
/// variables; nothing if there are more than `most`.
std::optional<std::vector<std::int8_t>> enumerate_values(const BeliefTask& task,
                                                         const std::vector<std::int32_t>& variables,
                                                         std::size_t most);

/// All first states, in a fixed order; nothing if there are more than `most`.
std::optional<std::vector<WorldState>> enumerate_worlds(const BeliefTask& task, std::size_t most);

}  // namespace praxis::belief
