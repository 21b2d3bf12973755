// Plan neighbourhood graph search (Nakhost and Mueller 2010): the states around those of a plan,
// breadth-first by applicable operators up to a number of states, and the cheapest way to the goal in the
// graph they make.
#pragma once

#include <cstddef>
#include <vector>

#include "search/engines/search.hpp"

namespace praxis {

struct NeighbourhoodLimits {
    std::size_t max_states = 1'000'000;
    std::size_t max_bytes = std::size_t{512} << 20;
};

struct Neighbourhood {
    std::vector<OperatorId> plan;  ///< a cheapest one in the graph
    bool complete = false;         ///< all states that can be reached are in the graph: the plan is optimal
};

/// `plan` is a plan of the query; it is returned unless there is a better one. Time is
/// kept back to search the graph, so that what was made of it counts when the budget runs out.
Neighbourhood search_neighbourhood(const PreparedTask& prepared, const Query& query,
                                   std::vector<OperatorId> plan, const Budget& budget,
                                   const NeighbourhoodLimits& limits = {});

}  // namespace praxis
