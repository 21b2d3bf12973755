#include "tamp/scenes/voxelize.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/tamp/collision/random_pose.hpp"

namespace praxis::tamp {
namespace {

Mesh random_mesh(Random& random) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const auto corner = [&] { return random_pose(random, 0.5).translation(); };
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        for (int j = 0; j < 3; ++j) mesh.vertices.emplace_back(corner());
    }
    return mesh;
}

RC_GTEST_PROP(Voxelize, EveryPointOfTheSurfaceIsInAFilledCell, (std::uint64_t seed)) {
    Random random(seed);
    const Mesh mesh = random_mesh(random);
    const VoxelSet voxels = voxelize(mesh, 0.06);
    for (int i = 0; i < 200; ++i) {
        const auto& corners = mesh.triangles[random.below(mesh.triangles.size())];
        double a = uniform(random, 0, 1);
        double b = uniform(random, 0, 1);
        if (a + b > 1) {
            a = 1 - a;
            b = 1 - b;
        }
        const Vector3& origin = mesh.vertices[corners[0]];
        const Vector3 point =
            origin + a * (mesh.vertices[corners[1]] - origin) + b * (mesh.vertices[corners[2]] - origin);
        std::array<int, 3> cell = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double place = point[static_cast<Eigen::Index>(axis)] - voxels.grid.origin[axis];
            cell[axis] = static_cast<int>(std::floor(place / voxels.grid.edge));
        }
        RC_ASSERT(voxels.grid.has(cell[0], cell[1], cell[2]));
        RC_ASSERT(voxels.filled[voxels.grid.index(cell[0], cell[1], cell[2])] == 1);
    }
}

Mesh triangle(const Vector3& a, const Vector3& b, const Vector3& c) {
    return {.name = "triangle", .vertices = {a, b, c}, .triangles = {{0, 1, 2}}};
}

int count(const VoxelSet& voxels) {
    return std::accumulate(voxels.filled.begin(), voxels.filled.end(), 0);
}

TEST(Voxelize, FillsNoMoreThanTheTriangleMeets) {
    // Half of a square of ten by ten cells, the diagonal included.
    EXPECT_EQ(count(voxelize(triangle({0.01, 0.01, 0.05}, {0.97, 0.01, 0.05}, {0.01, 0.97, 0.05}), 0.1)), 55);
    EXPECT_EQ(count(voxelize(triangle({0.05, 0.05, 0.05}, {0.06, 0.05, 0.05}, {0.05, 0.06, 0.05}), 0.1)), 1);
}

TEST(Voxelize, ImpossibleMeshesAreRefused) {
    Mesh broken = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    EXPECT_THROW(voxelize(broken, 0), std::invalid_argument);
    EXPECT_THROW(voxelize(broken, 1e-9), std::invalid_argument);
    EXPECT_THROW(voxelize(Mesh(), 0.1), std::invalid_argument);
    broken.triangles[0][1] = 7;
    EXPECT_THROW(voxelize(broken, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
