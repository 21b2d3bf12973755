// How deep a point lies in a solid.
#pragma once

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// Metres from `point` (in the frame of the shape) to the surface of the shape: negative inside. Spheres,
/// boxes, cylinders and capsules; infinite for what is not solid (meshes, maps). Exact inside; outside a
/// lower bound.
double signed_distance(const Shape& shape, const Vector3& point);

}  // namespace praxis::tamp
