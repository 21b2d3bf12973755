// The cover of a mesh's surface; see cover.hpp.
#pragma once

#include <vector>

#include "tamp/geometry/cover.hpp"

namespace praxis::tamp {

/// Throws std::invalid_argument for a mesh without triangles, with indices out of range or with vertices that
/// are not finite.
std::vector<Ball> cover_mesh(const Mesh& mesh, const CoverOptions& options);

}  // namespace praxis::tamp
