// The cover of a cylinder; see cover.hpp.
#pragma once

#include <vector>

#include "tamp/geometry/cover.hpp"

namespace praxis::tamp {

/// For sizes that are finite and not negative, and options that `cover` has checked. Exact up to rounding.
std::vector<Ball> cover_cylinder(const Cylinder& cylinder, const CoverOptions& options);

}  // namespace praxis::tamp
