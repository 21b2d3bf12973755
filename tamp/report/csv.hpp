// Trajectory documents as comma-separated values.
#pragma once

#include <iosfwd>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// A heading `t`, the variables' names, `gripper`, `event`; then a row at each k / `rate` seconds (rate > 0,
/// rows a second), and at each time when something happens. `gripper` names what is held; `event` what begins
/// or happens at this time: "(pick a)", "attach a", "detach a". Several are separated by "; ". Fields are
/// quoted as RFC 4180 says. Throws std::invalid_argument for another rate, for more than 10 million rows,
/// and as `check_document` does.
void write_csv(const TrajectoryDocument& document, double rate, std::ostream& out);

}  // namespace praxis::tamp
