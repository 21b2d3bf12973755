// Maps from points that a sensor saw.
#pragma once

#include <optional>
#include <span>

#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

struct PointMapOptions {
    double edge = 0.02;  ///< of a voxel, metres
    std::optional<AxisBox> box =
        {};  ///< what the map speaks of; none: the box around the points (and the sensor)
    /// Where the sensor stood: voxels between it and a point are free, others unknown. None: every voxel
    /// without points is free, for then nothing tells what was seen.
    std::optional<Vector3> sensor = {};
    std::size_t least_points = 1;  ///< a voxel with fewer is noise, and not occupied
    bool unknown_blocks = true;
};

/// A voxel with enough points is occupied, even if rays to points behind it cross it. Points outside of the
/// box count for their rays only; points that are not finite are skipped (sensors mark misses so). Throws
/// std::invalid_argument for options out of range, and if there is neither a point nor a box.
OccupancyMap map_points(std::span<const Vector3> points, const PointMapOptions& options = {});

}  // namespace praxis::tamp
