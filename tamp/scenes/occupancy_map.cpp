#include "tamp/scenes/occupancy_map.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

/// Takes filled cells out of the set while boxes are found.
class Merger {
  public:
    explicit Merger(const VoxelSet& voxels) : grid_(voxels.grid), filled_(voxels.filled) {}

    std::vector<AxisBox> boxes() {
        std::vector<AxisBox> found;
        for (int k = 0; k < grid_.cells[2]; ++k) {
            for (int j = 0; j < grid_.cells[1]; ++j) {
                for (int i = 0; i < grid_.cells[0]; ++i) {
                    if (filled_[grid_.index(i, j, k)] != 0) found.push_back(take({i, j, k}));
                }
            }
        }
        return found;
    }

  private:
    bool is_filled(const CellBox& box) const {
        for (int k = box.lower[2]; k < box.upper[2]; ++k) {
            for (int j = box.lower[1]; j < box.upper[1]; ++j) {
                const std::uint8_t* row = &filled_[grid_.index(box.lower[0], j, k)];
                if (std::find(row, row + (box.upper[0] - box.lower[0]), 0) !=
                    row + (box.upper[0] - box.lower[0])) {
                    return false;
                }
            }
        }
        return true;
    }

    /// The cells of a box that is grown along x, then y, then z.
    AxisBox take(const std::array<int, 3>& cell) {
        CellBox box = {cell, {cell[0] + 1, cell[1] + 1, cell[2] + 1}};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            CellBox next = box;
            while (box.upper[axis] < grid_.cells[axis]) {
                next.lower[axis] = box.upper[axis];
                next.upper[axis] = box.upper[axis] + 1;
                if (!is_filled(next)) break;
                ++box.upper[axis];
            }
        }
        for (int k = box.lower[2]; k < box.upper[2]; ++k) {
            for (int j = box.lower[1]; j < box.upper[1]; ++j) {
                std::fill_n(&filled_[grid_.index(box.lower[0], j, k)], box.upper[0] - box.lower[0],
                            std::uint8_t{0});
            }
        }
        AxisBox metric;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<Eigen::Index>(axis);
            metric.lower[at] = grid_.origin[axis] + grid_.edge * box.lower[axis];
            metric.upper[at] = grid_.origin[axis] + grid_.edge * box.upper[axis];
        }
        return metric;
    }

    const VoxelGrid& grid_;
    std::vector<std::uint8_t> filled_;
};

void check_grid(const VoxelGrid& grid) {
    if (!(grid.edge > 0) || !std::isfinite(grid.edge)) {
        throw std::invalid_argument("the voxels of a map need an edge above 0");
    }
    double cells = 1;
    for (const int side : grid.cells) cells *= std::max(side, 0);
    if (cells < 1) throw std::invalid_argument("a map needs at least one voxel");
    if (cells > static_cast<double>(OccupancyMap::kMostCells)) {
        throw std::invalid_argument("a map of more than 67 million voxels is too large; give a smaller box");
    }
    if (!std::ranges::all_of(grid.origin, [](double number) { return std::isfinite(number); })) {
        throw std::invalid_argument("the origin of a map must be finite");
    }
}

}  // namespace

OccupancyMap::OccupancyMap(const VoxelGrid& grid, std::vector<Occupancy> cells, bool unknown_blocks)
    : grid_(grid), cells_(std::move(cells)), unknown_blocks_(unknown_blocks) {
    check_grid(grid_);
    if (cells_.size() != grid_.size()) {
        throw std::invalid_argument("a map of " + std::to_string(grid_.size()) + " voxels was given " +
                                    std::to_string(cells_.size()));
    }
    boxes_ = merge_voxels(obstacles());
}

std::size_t OccupancyMap::count(Occupancy occupancy) const {
    return static_cast<std::size_t>(std::ranges::count(cells_, occupancy));
}

VoxelSet OccupancyMap::obstacles() const {
    VoxelSet voxels = {grid_, std::vector<std::uint8_t>(cells_.size())};
    std::ranges::transform(cells_, voxels.filled.begin(), [&](Occupancy cell) {
        const bool blocks = cell == Occupancy::occupied || (cell == Occupancy::unknown && unknown_blocks_);
        return static_cast<std::uint8_t>(blocks ? 1 : 0);
    });
    return voxels;
}

VoxelGrid aligned_grid(const AxisBox& box, double edge) {
    if (!(edge > 0) || !std::isfinite(edge)) {
        throw std::invalid_argument("the voxels of a map need an edge above 0");
    }
    VoxelGrid grid;
    grid.edge = edge;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double kTolerance = 1e-6;
        const auto at = static_cast<Eigen::Index>(axis);
        const double lower = std::floor(box.lower[at] / edge + kTolerance);
        const double upper = std::ceil(box.upper[at] / edge - kTolerance);
        if (!(upper > lower)) throw std::invalid_argument("the box of a map is empty or not finite");
        if (upper - lower > static_cast<double>(OccupancyMap::kMostCells)) {
            throw std::invalid_argument(
                "a map of more than 67 million voxels is too large; give a smaller box");
        }
        grid.origin[axis] = lower * edge;
        grid.cells[axis] = static_cast<int>(upper - lower);
    }
    check_grid(grid);
    return grid;
}

std::vector<AxisBox> merge_voxels(const VoxelSet& voxels) {
    return Merger(voxels).boxes();
}

}  // namespace praxis::tamp
