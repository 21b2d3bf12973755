// How far a point is from a triangle.
#pragma once

#include <algorithm>

#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

/// Of `point` from the segment between `from` and `to` (which may be equal).
inline double squared_distance(const Vector3& point, const Vector3& from, const Vector3& to) {
    const Vector3 along = to - from;
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp(along.dot(point - from) / length, 0.0, 1.0) : 0.0;
    return (point - from - part * along).squaredNorm();
}

/// Of `point` from the triangle a b c: from its plane where the point stands over the triangle, from the
/// nearest side elsewhere. Triangles may be flat.
inline double squared_distance(const Vector3& point, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 normal = (b - a).cross(c - a);
    const double area = normal.squaredNorm();
    const bool over = area > 0 && normal.dot((b - a).cross(point - a)) >= 0 &&
                      normal.dot((c - b).cross(point - b)) >= 0 && normal.dot((a - c).cross(point - c)) >= 0;
    if (over) {
        const double height = normal.dot(point - a);
        return height * height / area;
    }
    return std::min(
        {squared_distance(point, a, b), squared_distance(point, b, c), squared_distance(point, c, a)});
}

}  // namespace praxis::tamp
