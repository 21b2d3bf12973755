// Where a mobile base stands to reach something.
#pragma once

#include <vector>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

struct BasePoseOptions {
    double nearest = 0.35;   ///< metres from the base to what it reaches for, at least
    double furthest = 0.75;  ///< and at most
    int count = 24;
};

/// Base poses (x, y, yaw) on rings around a point of the world, each turned towards it: first where the base
/// is now (if that is near enough), then on the side that it comes from, then further around. Distinct,
/// without random choices; yaw within half a turn of `now`'s.
std::vector<Configuration> make_base_poses(const Vector3& around, const Configuration& now,
                                           const BasePoseOptions& options = {});

}  // namespace praxis::tamp
