// Making a plan cheaper after it was found: redundant steps are removed, then better ways are searched around
// what is left, by turns, until neither helps (the scheme of ARAS, Nakhost and Mueller 2010).
#pragma once

#include <cstddef>
#include <vector>

#include "search/engines/search.hpp"

namespace praxis {

struct ImproveOptions {
    std::size_t max_states = 1'000'000;              ///< in one neighbourhood, and in one elimination
    std::size_t max_bytes = std::size_t{512} << 20;  ///< of one neighbourhood, about
    std::size_t window_states = 300;                 ///< of one window; 0: windows are not searched
};

/// A plan of the query that costs no more than `plan`, by the task's costs, and where it costs as much has no
/// more steps; `plan` itself if nothing better is found. The same every time, unless the budget runs out:
/// then the best so far. Throws std::invalid_argument if `plan` is not a plan of the query.
std::vector<OperatorId> improve_plan(const PreparedTask& prepared, const Query& query,
                                     std::vector<OperatorId> plan, const Budget& budget,
                                     const ImproveOptions& options = {});

}  // namespace praxis
