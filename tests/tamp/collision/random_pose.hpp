#pragma once

#include <cmath>
#include <numbers>

#include "search/engines/random.hpp"
#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

inline double uniform(Random& random, double lower, double upper) {
    return lower + (upper - lower) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

/// Anywhere in the cube of half side `reach`, turned anyhow.
inline Pose random_pose(Random& random, double reach) {
    const auto coordinate = [&] { return uniform(random, -reach, reach); };
    const auto angle = [&] { return uniform(random, -std::numbers::pi, std::numbers::pi); };
    const Vector3 position = {coordinate(), coordinate(), coordinate()};
    const Vector3 angles = {angle(), angle(), angle()};
    return pose_from_rpy(position, angles);
}

}  // namespace praxis::tamp
