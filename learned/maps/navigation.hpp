// Random mazes of the kind that planner networks are trained on (Lee et al., Gated path planning networks,
// ICML 2018).
#pragma once

#include "learned/maps/map_problem.hpp"
#include "search/engines/random.hpp"

namespace praxis::learned {

/// A depth-first maze of size x size cells, opened up: each inner wall is removed with a probability that is
/// itself drawn for the map from [0, decimation). The goal is any inner cell. Odd sizes have a closed border;
/// even ones are carved up to their last row and column, as published. Labels are drawn among the optimal
/// moves. std::invalid_argument for sizes below 5 or above 255.
MapProblem navigation_problem(int size, Random& random, double decimation = 1);

/// So many of them.
MapSet navigation_set(int size, std::size_t count, std::uint64_t seed, double decimation = 1);

}  // namespace praxis::learned
