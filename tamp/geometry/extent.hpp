// Boxes along the axes around shapes.
#pragma once

#include <span>

#include "tamp/geometry/axis_box.hpp"
#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// The smallest such box around the shape standing at `pose` (times its own pose). Around a map: around the
/// box of its grid. Throws std::invalid_argument for a mesh without vertices.
AxisBox extent(const PlacedShape& shape, const Pose& pose = Pose::Identity());

/// Around several; there must be one.
AxisBox extent(std::span<const PlacedShape> shapes, const Pose& pose = Pose::Identity());

}  // namespace praxis::tamp
