// How far every cell of a grid is from the nearest filled one: a lower bound for all points in the cell.
//
// The number of a cell is the exact distance between its cube and the nearest filled cube (0 for filled cells
// and their neighbours): no point of the cell is nearer to any filled point. A ball with its centre in the
// cell and a radius below that number is free. A point outside of the grid is as far as the nearest point of
// the grid at least, so that it may be looked up there (clamp its coordinates).
//
// The distance between two cubes is that between the centres of one and the nearest of the 27 around the
// other. So a distance transform of the filled cells, each spread by one cell in all directions, is exact:
// Felzenszwalb and Huttenlocher, "Distance Transforms of Sampled Functions" (2012), one axis after the other.
// The result of each axis is kept (12 bytes a cell in all), and a change runs again only the lines that it
// reaches: fewer of them if distances are cut off at what somebody asks for (the largest ball, say).
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "tamp/scenes/voxel_grid.hpp"

namespace praxis::tamp {

class DistanceGrid {
  public:
    /// Where no cell is filled (and no reach given).
    static constexpr float kInfinite = std::numeric_limits<float>::infinity();

    DistanceGrid() = default;
    /// No number will be larger than `reach` metres. Throws std::invalid_argument if the set has another
    /// number of cells than its grid, a side of more than 1024 cells or none, or if an edge or reach is not
    /// above 0.
    explicit DistanceGrid(const VoxelSet& voxels, double reach = std::numeric_limits<double>::infinity());

    const VoxelGrid& grid() const { return grid_; }
    /// Metres, by index; rounded down.
    std::span<const float> distances() const { return distances_; }

    /// After `filled` (by index, of the whole grid) changed within `changed`. Throws std::invalid_argument if
    /// the box is not within the grid or the number of cells differs.
    void update(std::span<const std::uint8_t> filled, const CellBox& changed);

  private:
    void along_x(std::span<const std::uint8_t> filled, const CellBox& lines);
    void along_y(const CellBox& lines, std::vector<std::uint8_t>* changed_columns);
    void along_z(std::span<const std::uint8_t> columns);

    VoxelGrid grid_;
    float reach_ = kInfinite;          ///< metres
    float squared_reach_ = kInfinite;  ///< in cells; what lies beyond counts as infinite
    std::vector<float> by_x_;          ///< squared distances in cells, along x only
    std::vector<float> by_xy_;         ///< in planes of equal z
    std::vector<float> distances_;
};

}  // namespace praxis::tamp
