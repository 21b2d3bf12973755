// What is known of a bounded box of space: which of its voxels are occupied, free, or never seen.
//
// Unknown voxels are obstacles unless the map's maker says otherwise. The box bounds what that means: nothing
// is claimed of the space outside of it. Made from OctoMap files (`read_octomap.hpp`) and from points
// (`map_points.hpp`). Immutable; shared between snapshots of the world.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tamp/geometry/axis_box.hpp"
#include "tamp/scenes/voxel_grid.hpp"

namespace praxis::tamp {

enum class Occupancy : std::uint8_t { unknown, free, occupied };

class OccupancyMap {
  public:
    /// `cells` by index of the grid. Throws std::invalid_argument if their number is another than the grid's,
    /// or the grid has no cells, more than `kMostCells`, or an edge that is not above 0.
    OccupancyMap(const VoxelGrid& grid, std::vector<Occupancy> cells, bool unknown_blocks = true);

    static constexpr std::size_t kMostCells = std::size_t{1} << 26;

    /// In the frame of the body that the map belongs to.
    const VoxelGrid& grid() const { return grid_; }
    const std::vector<Occupancy>& cells() const { return cells_; }
    bool unknown_blocks() const { return unknown_blocks_; }
    std::size_t count(Occupancy occupancy) const;

    /// Occupied cells, and unknown ones where they block.
    VoxelSet obstacles() const;
    /// Boxes that fill exactly the same space as the obstacles, fewer by far: found once, greedily.
    const std::vector<AxisBox>& boxes() const { return boxes_; }

  private:
    VoxelGrid grid_;
    std::vector<Occupancy> cells_;
    bool unknown_blocks_ = true;
    std::vector<AxisBox> boxes_;
};

/// The grid of cells with corners at multiples of `edge` that covers `box`. Throws std::invalid_argument if
/// it is empty, not finite, or would have more than `OccupancyMap::kMostCells` cells.
VoxelGrid aligned_grid(const AxisBox& box, double edge);

/// Boxes that fill exactly the filled cells: rows, then equal rows side by side, then equal slabs.
std::vector<AxisBox> merge_voxels(const VoxelSet& voxels);

}  // namespace praxis::tamp
