// Window optimisation: parts of a plan are replaced by cheaper ways (after Siddiqui and Haslum 2015; here
// windows are consecutive steps of the plan as it stands).
//
// The goal of a window is what the steps after it need: the regression of the goal over them, or, if axioms
// or conditional effects come into play, the whole state. A window is searched by A* with the landmark-cut
// heuristic, everything that is not better than the window itself cut off.
#pragma once

#include <cstddef>
#include <vector>

#include "search/engines/search.hpp"

namespace praxis {

/// `plan`, a plan of the query, with all windows replaced for which a better way is found among `max_states`
/// states each. Windows of a few steps come first, longer ones after that.
std::vector<OperatorId> improve_windows(const PreparedTask& prepared, const Query& query,
                                        std::vector<OperatorId> plan, const Budget& budget,
                                        std::size_t max_states);

}  // namespace praxis
