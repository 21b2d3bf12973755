// How good a policy is: follow its best moves from every cell that reaches the goal.
//
// On each map, and then in the mean over maps: success is the share of those cells (the goal itself not
// counted) from which the policy arrives; optimal, the share from which it arrives on a shortest path; SPL,
// the mean of shortest length / length, 0 where it does not arrive (Anderson et al., On evaluation of
// embodied navigation agents, 2018).
#pragma once

#include "learned/maps/map_problem.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

struct Score {
    double success = 0, optimal = 0, spl = 0;  ///< 0 to 1
};

/// Of moves: policy[cell] in 0..3. A map with no cell but the goal scores 1.
Score score(const MapProblem& problem, std::span<const std::uint8_t> policy);

/// The best move at each cell (the first of equals).
template <class T>
std::vector<std::uint8_t> best_moves(const Planes<T>& policy);

/// The mean over all maps, on so many threads.
template <class T>
Score evaluate(const Planner<T>& planner, const MapSet& maps, int threads = 1);

}  // namespace praxis::learned
