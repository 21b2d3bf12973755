#include "tamp/scenes/occupancy_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "search/engines/random.hpp"
#include "tamp/scenes/map_points.hpp"

namespace praxis::tamp {
namespace {

Occupancy at(const OccupancyMap& map, const Vector3& point) {
    std::array<int, 3> cell = {};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double place = point[static_cast<Eigen::Index>(axis)] - map.grid().origin[axis];
        cell[axis] = static_cast<int>(std::floor(place / map.grid().edge));
    }
    return map.cells()[map.grid().index(cell[0], cell[1], cell[2])];
}

RC_GTEST_PROP(OccupancyMap, MergedBoxesFillExactlyTheObstacles, (std::uint64_t seed)) {
    Random random(seed);
    VoxelSet voxels;
    voxels.grid = {.origin = {-1, 2, 0}, .edge = 0.5, .cells = {}};
    for (int& side : voxels.grid.cells) side = 1 + static_cast<int>(random.below(8));
    const std::size_t odds = 1 + random.below(5);
    for (std::size_t i = 0; i < voxels.grid.size(); ++i) {
        voxels.filled.push_back(random.below(odds) == 0 ? 1 : 0);
    }
    const std::vector<AxisBox> boxes = merge_voxels(voxels);
    for (int k = 0; k < voxels.grid.cells[2]; ++k) {
        for (int j = 0; j < voxels.grid.cells[1]; ++j) {
            for (int i = 0; i < voxels.grid.cells[0]; ++i) {
                const Vector3 center = Vector3(-1, 2, 0) + 0.5 * Vector3(i + 0.5, j + 0.5, k + 0.5);
                const auto within = std::ranges::count_if(
                    boxes, [&](const AxisBox& box) { return box.squared_distance(center) == 0; });
                RC_ASSERT(within == voxels.filled[voxels.grid.index(i, j, k)]);
            }
        }
    }
}

TEST(OccupancyMap, UnknownVoxelsBlockUnlessToldOtherwise) {
    const VoxelGrid grid = {.edge = 1, .cells = {3, 1, 1}};
    const std::vector<Occupancy> cells = {Occupancy::unknown, Occupancy::free, Occupancy::occupied};
    EXPECT_EQ(OccupancyMap(grid, cells).obstacles().filled, (std::vector<std::uint8_t>{1, 0, 1}));
    EXPECT_EQ(OccupancyMap(grid, cells, false).obstacles().filled, (std::vector<std::uint8_t>{0, 0, 1}));
    EXPECT_EQ(OccupancyMap(grid, cells).boxes().size(), 2U);
    EXPECT_EQ(OccupancyMap(grid, cells, false).boxes().size(), 1U);
}

TEST(OccupancyMap, ImpossibleGridsAreRefused) {
    EXPECT_THROW(OccupancyMap({.edge = 1, .cells = {2, 1, 1}}, {Occupancy::free}), std::invalid_argument);
    EXPECT_THROW(OccupancyMap({.edge = 0, .cells = {1, 1, 1}}, {Occupancy::free}), std::invalid_argument);
    EXPECT_THROW(OccupancyMap({.edge = 1, .cells = {100000, 100000, 100000}}, {}), std::invalid_argument);
    EXPECT_THROW(aligned_grid({{0, 0, 0}, {1e9, 1, 1}}, 0.01), std::invalid_argument);
    EXPECT_THROW(aligned_grid({{0, 0, 0}, {0, 1, 1}}, 0.01), std::invalid_argument);
    EXPECT_THROW(aligned_grid({{std::nan(""), 0, 0}, {1, 1, 1}}, 0.01), std::invalid_argument);
}

TEST(OccupancyMap, GridsAreAlignedToMultiplesOfTheEdge) {
    const VoxelGrid grid = aligned_grid({{-0.05, 0.1, 0.21}, {0.35, 0.3, 0.39}}, 0.1);
    EXPECT_EQ(grid.cells, (std::array<int, 3>{5, 2, 2}));
    EXPECT_NEAR(grid.origin[0], -0.1, 1e-12);
    EXPECT_NEAR(grid.origin[1], 0.1, 1e-12);
}

TEST(MapPoints, RaysClearWhatTheyCross) {
    const std::vector<Vector3> points = {{0.95, 0.05, 0.05}, {0.05, 0.95, 0.05}, {std::nan(""), 0, 0}};
    PointMapOptions options;
    options.edge = 0.1;
    options.sensor = Vector3(0.05, 0.05, 0.05);
    const OccupancyMap map = map_points(points, options);
    EXPECT_EQ(map.count(Occupancy::occupied), 2U);
    EXPECT_EQ(at(map, {0.95, 0.05, 0.05}), Occupancy::occupied);
    EXPECT_EQ(at(map, {0.05, 0.05, 0.05}), Occupancy::free);
    EXPECT_EQ(at(map, {0.85, 0.05, 0.05}), Occupancy::free);
    EXPECT_EQ(at(map, {0.55, 0.55, 0.05}), Occupancy::unknown);
    EXPECT_EQ(map.count(Occupancy::free), 17U);
}

TEST(MapPoints, WithoutASensorOnlyPointsBlock) {
    const std::vector<Vector3> points = {{0.95, 0.05, 0.05}, {0.05, 0.95, 0.05}};
    const OccupancyMap map = map_points(points, {.edge = 0.1});
    EXPECT_EQ(map.count(Occupancy::unknown), 0U);
    EXPECT_EQ(map.boxes().size(), 2U);
}

TEST(MapPoints, FewPointsAreNoise) {
    const std::vector<Vector3> points = {{0.5, 0.5, 0.5}, {0.51, 0.5, 0.5}, {0.05, 0.5, 0.5}};
    PointMapOptions options = {.edge = 0.1, .least_points = 2};
    options.box = AxisBox{{0, 0, 0}, {1, 1, 1}};
    const OccupancyMap map = map_points(points, options);
    EXPECT_EQ(map.count(Occupancy::occupied), 1U);
    EXPECT_EQ(at(map, {0.55, 0.55, 0.55}), Occupancy::occupied);
}

TEST(MapPoints, TheBoxBoundsWhatIsClaimed) {
    PointMapOptions options = {.edge = 0.1};
    options.box = AxisBox{{0, 0, 0}, {1, 0.1, 0.1}};
    options.sensor = Vector3(-1, 0.05, 0.05);
    // The point lies beyond: the whole row is seen to be free.
    const OccupancyMap map = map_points(std::vector<Vector3>{{3, 0.05, 0.05}}, options);
    EXPECT_EQ(map.count(Occupancy::free), 10U);
    EXPECT_EQ(map_points({}, options).count(Occupancy::unknown), 10U);
    EXPECT_THROW(map_points({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
