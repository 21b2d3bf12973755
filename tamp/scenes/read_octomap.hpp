// OctoMap's files (Hornung et al. 2013): .bt (occupied or free) and .ot (log-odds; occupied from even odds
// on).
//
// Read by our own few lines straight into the dense grid: OctoMap's reader recurses as deep as a damaged file
// tells it to.
#pragma once

#include <optional>
#include <string>

#include "parser/source.hpp"
#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

struct OctomapOptions {
    std::optional<AxisBox> box = {};  ///< what the map speaks of; none: the box around all known voxels
    bool unknown_blocks = true;
};

/// Throws InputError if the text is no OctoMap of kind OcTree, is damaged, or has more voxels in the box than
/// an OccupancyMap may have. `file` holds the bytes of the file and its name.
OccupancyMap parse_octomap(const Source& file, const OctomapOptions& options = {});

}  // namespace praxis::tamp
