// Where things may be put: rectangles that look up.
#pragma once

#include <string>

#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A rectangle on a body (or fixed in the world). Its frame lies in the middle, z upwards; it reaches from
/// -width/2 to width/2 along x and from -depth/2 to depth/2 along y.
struct Region {
    std::string name = {};
    int body = -1;                  ///< that it is on, and moves with; -1: the world
    Pose frame = Pose::Identity();  ///< in that body, or in the world
    double width = 0;               ///< metres
    double depth = 0;               ///< metres
};

/// The region's frame in the world.
inline Pose region_pose(const World& world, const Region& region) {
    return region.body < 0 ? region.frame : world[region.body].pose * region.frame;
}

}  // namespace praxis::tamp
