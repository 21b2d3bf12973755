// Boxes along the axes: what broad phases compare.
#pragma once

#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

/// All points between `lower` and `upper`.
struct AxisBox {
    Vector3 lower = Vector3::Zero();
    Vector3 upper = Vector3::Zero();

    Vector3 center() const { return 0.5 * (lower + upper); }
    Vector3 size() const { return upper - lower; }
    bool overlaps(const AxisBox& other) const {
        return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
    }
    /// Of `point` from the box; 0 inside.
    double squared_distance(const Vector3& point) const {
        return (point - point.cwiseMax(lower).cwiseMin(upper)).squaredNorm();
    }
    void include(const AxisBox& other) {
        lower = lower.cwiseMin(other.lower);
        upper = upper.cwiseMax(other.upper);
    }
};

/// Around the box that stands at `pose`.
inline AxisBox moved(const AxisBox& box, const Pose& pose) {
    const Vector3 center = pose * box.center();
    const Vector3 half = pose.linear().cwiseAbs() * (0.5 * box.size());
    return {center - half, center + half};
}

inline AxisBox box_around(const Vector3& center, double radius) {
    return {center.array() - radius, center.array() + radius};
}

}  // namespace praxis::tamp
