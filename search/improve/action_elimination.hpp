// Removing redundant steps from a plan.
//
// Greedy action elimination (Nakhost and Mueller 2010; the variant that takes the most expensive set first
// is by Balyo, Chrpa and Kilani 2014): take out one step and all that become inapplicable for want of it; if
// the goal still holds in the end, they were redundant.
//
// Optimal action elimination (Salerno, Fuentetaja and Seipp 2023) is the cheapest subsequence that is still a
// plan. It is found by going through the plan once with the set of all states that subsequences of the steps
// so far lead to, each with the cheapest way to it. Steps without which the goal or another such step cannot
// be reached even if nothing is ever deleted are never left out; ways that cost no less than the plan in
// hand, the steps that must follow included, are dropped, as are states that lack a goal fact which no later
// step adds.
#pragma once

#include <cstddef>
#include <vector>

#include "search/engines/search.hpp"

namespace praxis {

struct EliminationLimits {
    std::size_t max_nodes = 200'000;     ///< ways of the optimal elimination that are remembered
    std::size_t max_steps = 20'000'000;  ///< steps executed, in each of the greedy and the optimal part
};

struct Elimination {
    std::vector<OperatorId> plan;
    bool optimal = false;  ///< no subsequence of the plan that was given is a plan and better
};

/// The plan with steps left out. `plan` is a plan of the query. Greedy only, if the limits do not suffice.
Elimination eliminate_actions(const PreparedTask& prepared, const Query& query, std::vector<OperatorId> plan,
                              const Budget& budget, const EliminationLimits& limits = {});

/// The greedy part alone.
std::vector<OperatorId> eliminate_actions_greedily(const PreparedTask& prepared, const Query& query,
                                                   std::vector<OperatorId> plan, const Budget& budget,
                                                   const EliminationLimits& limits = {});

}  // namespace praxis
