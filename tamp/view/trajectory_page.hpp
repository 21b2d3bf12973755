// Trajectory documents as pages: one HTML file that needs nothing else, shows the scene in three dimensions
// and plays the plan. docs/viewer.md says how to use it.
#pragma once

#include <iosfwd>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Whether this build has the viewer (the CMake option PRAXIS_BUILD_VIEWER, which needs npm).
bool has_viewer();

/// Writes the page. Names are shown as they are, whatever they contain. Throws UnsupportedError in a build
/// without the viewer, and std::invalid_argument as `check_document` does.
void write_view(const TrajectoryDocument& document, std::ostream& out);

}  // namespace praxis::tamp
