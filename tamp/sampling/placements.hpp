// Where a body can stand in an area: upright, wholly inside, a little above the surface.
//
// Placements are numbered, and a number gives the same placement always: first a grid of places, then an even
// spread (Halton) up to `count`. So "every placement was tried" means something: it is the discretisation.
// Whether something else is there is not looked at (`collision/body_checker.hpp` does).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tamp/sampling/area.hpp"

namespace praxis::tamp {

struct PlacementOptions {
    std::uint32_t count = 64;  ///< placements of a body in an area
    double margin = 0.002;     ///< metres that the body stays inside of the area's border
    /// Turns about z that are tried, radians, relative to the area's frame.
    std::vector<double> yaws = {0, 1.5707963267948966, 0.7853981633974483, 2.356194490192345};
    bool grid = true;  ///< the middle and the corners first, for tight packing; else only the even spread
};

/// Placement `number` (from 0): the body's pose in the world. Nothing where the number is not below `count`,
/// or the body does not fit there.
std::optional<Pose> make_placement(const BodyModel& body, const World& world, const Area& area,
                                   std::uint32_t number, const PlacementOptions& options = {});

/// Whether the body stands in the area at this pose: upright, inside, and at most `height` metres above it.
bool stands_in(const BodyModel& body, const Pose& pose, const World& world, const Area& area,
               double height = 2 * kPlacementGap);

}  // namespace praxis::tamp
