// The independent check of a run: the executed actions on the lifted task as it is written, from the first
// state of the world.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "belief/worlds.hpp"
#include "search/validate.hpp"

namespace praxis::belief {

/// Executes the actions with the validator of classical plans, which shares nothing with the simulated world.
/// The verdict is about the world, not about what is believed. `after_chance`: the states after those actions
/// that leave something open (`forgotten`), from which the validator goes on; throws std::invalid_argument if
/// there are too few.
Verdict check_run(const BeliefTask& task, const WorldState& first, const std::vector<std::uint32_t>& actions,
                  std::span<const WorldState> after_chance = {});

}  // namespace praxis::belief
