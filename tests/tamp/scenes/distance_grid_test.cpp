#include "tamp/scenes/distance_grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "search/engines/random.hpp"

namespace praxis::tamp {
namespace {

/// A grid of up to 12 cells a side, each filled with the same small chance.
VoxelSet random_voxels(Random& random) {
    VoxelSet voxels;
    voxels.grid.edge = 0.05;
    for (int& side : voxels.grid.cells) side = 1 + static_cast<int>(random.below(12));
    const std::size_t odds = 2 + random.below(400);
    for (std::size_t i = 0; i < voxels.grid.size(); ++i) {
        voxels.filled.push_back(random.below(odds) == 0 ? 1 : 0);
    }
    return voxels;
}

/// The least distance between the cubes of a cell and of any filled cell.
std::vector<double> by_comparing_all(const VoxelSet& voxels) {
    const VoxelGrid& grid = voxels.grid;
    std::vector<std::array<int, 3>> cells;
    for (int k = 0; k < grid.cells[2]; ++k) {
        for (int j = 0; j < grid.cells[1]; ++j) {
            for (int i = 0; i < grid.cells[0]; ++i) cells.push_back({i, j, k});
        }
    }
    std::vector<double> distances;
    for (const auto& cell : cells) {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t other = 0; other < cells.size(); ++other) {
            if (voxels.filled[other] == 0) continue;
            double squared = 0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const int apart = std::max(std::abs(cell[axis] - cells[other][axis]) - 1, 0);
                squared += apart * apart;
            }
            best = std::min(best, grid.edge * std::sqrt(squared));
        }
        distances.push_back(best);
    }
    return distances;
}

bool nearly_below(std::span<const float> bounds, const std::vector<double>& exact) {
    return std::ranges::equal(bounds, exact, [](float bound, double distance) {
        return static_cast<double>(bound) <= distance &&
               (std::isinf(distance) ? std::isinf(bound) : bound > distance - 1e-5);
    });
}

RC_GTEST_PROP(DistanceGrid, IsTheGapBetweenCells, (std::uint64_t seed)) {
    Random random(seed);
    const VoxelSet voxels = random_voxels(random);
    RC_ASSERT(nearly_below(DistanceGrid(voxels).distances(), by_comparing_all(voxels)));
}

RC_GTEST_PROP(DistanceGrid, AReachCutsOffWhatIsFarther, (std::uint64_t seed)) {
    Random random(seed);
    const VoxelSet voxels = random_voxels(random);
    const double reach = 0.01 + 0.05 * static_cast<double>(random.below(8));
    std::vector<double> expected = by_comparing_all(voxels);
    for (double& distance : expected)
        distance = std::min(distance, static_cast<double>(static_cast<float>(reach)));
    RC_ASSERT(nearly_below(DistanceGrid(voxels, reach).distances(), expected));
}

RC_GTEST_PROP(DistanceGrid, UpdatesEqualBuildingAnew, (std::uint64_t seed)) {
    Random random(seed);
    VoxelSet voxels = random_voxels(random);
    const double reach = random.below(2) == 0 ? std::numeric_limits<double>::infinity() : 0.12;
    DistanceGrid grid(voxels, reach);
    CellBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto side = static_cast<std::size_t>(voxels.grid.cells[axis]);
        const std::size_t lower = random.below(side);
        box.lower[axis] = static_cast<int>(lower);
        box.upper[axis] = static_cast<int>(lower + random.below(side - lower + 1));
    }
    for (int k = box.lower[2]; k < box.upper[2]; ++k) {
        for (int j = box.lower[1]; j < box.upper[1]; ++j) {
            for (int i = box.lower[0]; i < box.upper[0]; ++i) {
                voxels.filled[voxels.grid.index(i, j, k)] = random.below(4) == 0 ? 1 : 0;
            }
        }
    }
    grid.update(voxels.filled, box);
    RC_ASSERT(std::ranges::equal(grid.distances(), DistanceGrid(voxels, reach).distances()));
}

TEST(DistanceGrid, WithoutFilledCellsAllIsFar) {
    const DistanceGrid grid(VoxelSet{{.edge = 1, .cells = {2, 3, 4}}, std::vector<std::uint8_t>(24, 0)});
    EXPECT_TRUE(std::ranges::all_of(grid.distances(), [](float distance) { return std::isinf(distance); }));
}

TEST(DistanceGrid, WrongUseIsRefused) {
    const VoxelGrid cube = {.edge = 1, .cells = {2, 2, 2}};
    EXPECT_THROW(DistanceGrid(VoxelSet{cube, std::vector<std::uint8_t>(7, 0)}), std::invalid_argument);
    EXPECT_THROW(DistanceGrid(VoxelSet{{.edge = 1, .cells = {0, 1, 1}}, {}}), std::invalid_argument);
    EXPECT_THROW(DistanceGrid(VoxelSet{cube, std::vector<std::uint8_t>(8, 0)}, 0), std::invalid_argument);
    EXPECT_THROW(DistanceGrid(VoxelSet{{.edge = 0, .cells = {1, 1, 1}}, {0}}), std::invalid_argument);
    const std::vector<std::uint8_t> none(8, 0);
    DistanceGrid grid(VoxelSet{cube, none});
    EXPECT_THROW(grid.update(none, {{0, 0, 0}, {3, 1, 1}}), std::invalid_argument);
    EXPECT_THROW(grid.update(none, {{1, 0, 0}, {0, 1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
