// Space in equal cubes. Plain numbers: the checkers' kernels include this, and they know no Eigen.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace praxis::tamp {

/// Where cells lie: cell (i, j, k) has its lower corner at origin + edge * (i, j, k). Metres.
struct VoxelGrid {
    std::array<double, 3> origin = {};
    double edge = 0;
    std::array<int, 3> cells = {};  ///< along x, y, z

    std::size_t size() const {
        return static_cast<std::size_t>(cells[0]) * static_cast<std::size_t>(cells[1]) *
               static_cast<std::size_t>(cells[2]);
    }
    /// Of a cell in arrays over the grid: x runs fastest, z slowest.
    std::size_t index(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(cells[1]) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(cells[0]) +
               static_cast<std::size_t>(i);
    }
    bool has(int i, int j, int k) const {
        return i >= 0 && j >= 0 && k >= 0 && i < cells[0] && j < cells[1] && k < cells[2];
    }
    friend bool operator==(const VoxelGrid&, const VoxelGrid&) = default;
};

/// Cells from `lower` up to but without `upper`, along each axis.
struct CellBox {
    std::array<int, 3> lower = {};
    std::array<int, 3> upper = {};
    friend bool operator==(const CellBox&, const CellBox&) = default;
};

/// Some cells of a grid.
struct VoxelSet {
    VoxelGrid grid = {};
    std::vector<std::uint8_t> filled = {};  ///< by index: 1 or 0
};

}  // namespace praxis::tamp
