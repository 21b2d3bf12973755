// Axis-aligned boxes around shapes.
#pragma once

#include <limits>
#include <span>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

struct Extent {
    Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity());
    Vector3 upper = Vector3::Constant(-std::numeric_limits<double>::infinity());

    bool empty() const { return !(lower.array() <= upper.array()).all(); }
    Vector3 center() const { return (lower + upper) / 2; }
    Vector3 size() const { return upper - lower; }
    void include(const Vector3& point) {
        lower = lower.cwiseMin(point);
        upper = upper.cwiseMax(point);
    }
};

/// Of the shapes in the frame in which they are placed, which itself may stand at `pose`. Tight for all
/// shapes but occupancy maps, which are left out.
Extent extent_of(std::span<const PlacedShape> shapes, const Pose& pose = Pose::Identity());

}  // namespace praxis::tamp
