#include "tamp/scenes/voxelize.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

namespace {

using Triangle = std::array<Vector3, 3>;

/// Whether a triangle meets the cube around the origin; lengths in edges of a cell.
class CubeTest {
  public:
    explicit CubeTest(const Triangle& triangle) : corner_(triangle[0]) {
        const Triangle sides = {triangle[1] - triangle[0], triangle[2] - triangle[1],
                                triangle[0] - triangle[2]};
        add(sides[0].cross(sides[1]), triangle);
        for (const Vector3& side : sides) {
            for (int axis = 0; axis < 3; ++axis) add(side.cross(Vector3::Unit(axis)), triangle);
        }
        for (int axis = 0; axis < 3; ++axis) add(Vector3::Unit(axis), triangle);
    }

    bool meets(const Vector3& center) const {
        return std::ranges::all_of(axes_, [&](const Axis& axis) {
            const double shift = axis.direction.dot(corner_ - center);
            return shift + axis.lower <= axis.reach && shift + axis.upper >= -axis.reach;
        });
    }

  private:
    struct Axis {
        Vector3 direction;
        double lower;  ///< the triangle's shadow, from its first corner
        double upper;
        double reach;  ///< half the cube's shadow
    };

    void add(const Vector3& direction, const Triangle& triangle) {
        constexpr double kHalf = 0.5 * (1 + 1e-6);
        const double first = direction.dot(triangle[1] - triangle[0]);
        const double second = direction.dot(triangle[2] - triangle[0]);
        axes_[count_++] = {direction, std::min({0.0, first, second}), std::max({0.0, first, second}),
                           kHalf * direction.cwiseAbs().sum()};
    }

    Vector3 corner_;
    std::array<Axis, 13> axes_ = {};
    std::size_t count_ = 0;
};

AxisBox box_of(const Triangle& triangle) {
    AxisBox box = {triangle[0], triangle[0]};
    for (const Vector3& corner : triangle) box.include({corner, corner});
    return box;
}

class Voxelizer {
  public:
    Voxelizer(const AxisBox& box, double edge) {
        const Vector3 margin = Vector3::Constant(0.01 * edge);
        voxels_.grid = aligned_grid({box.lower - margin, box.upper + margin}, edge);
        voxels_.filled.resize(voxels_.grid.size());
    }

    void add(const Triangle& triangle) {
        const VoxelGrid& grid = voxels_.grid;
        const Vector3 origin(grid.origin[0], grid.origin[1], grid.origin[2]);
        Triangle scaled = {};
        for (std::size_t i = 0; i < 3; ++i) scaled[i] = (triangle[i] - origin) / grid.edge;
        const AxisBox box = box_of(scaled);
        CellBox range;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            constexpr double kTolerance = 1e-6;
            const auto at = static_cast<Eigen::Index>(axis);
            range.lower[axis] = std::max(static_cast<int>(std::floor(box.lower[at] - kTolerance)), 0);
            range.upper[axis] =
                std::min(static_cast<int>(std::floor(box.upper[at] + kTolerance)) + 1, grid.cells[axis]);
        }
        const CubeTest test(scaled);
        for (int k = range.lower[2]; k < range.upper[2]; ++k) {
            for (int j = range.lower[1]; j < range.upper[1]; ++j) {
                for (int i = range.lower[0]; i < range.upper[0]; ++i) {
                    std::uint8_t& cell = voxels_.filled[grid.index(i, j, k)];
                    if (cell == 0 && test.meets({i + 0.5, j + 0.5, k + 0.5})) cell = 1;
                }
            }
        }
    }

    VoxelSet voxels() { return std::move(voxels_); }

  private:
    VoxelSet voxels_;
};

}  // namespace

VoxelSet voxelize(const Mesh& mesh, double edge) {
    if (mesh.triangles.empty()) throw std::invalid_argument("mesh '" + mesh.name + "' has no triangles");
    if (!(edge > 0)) throw std::invalid_argument("voxels need an edge above 0");
    std::vector<Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& corners : mesh.triangles) {
        Triangle triangle = {};
        for (std::size_t i = 0; i < 3; ++i) {
            if (corners[i] >= mesh.vertices.size() || !mesh.vertices[corners[i]].allFinite()) {
                throw std::invalid_argument("mesh '" + mesh.name +
                                            "' has a vertex that is not there or not finite");
            }
            triangle[i] = mesh.vertices[corners[i]];
        }
        triangles.push_back(triangle);
    }
    AxisBox box = box_of(triangles.front());
    for (const Triangle& triangle : triangles) box.include(box_of(triangle));
    Voxelizer voxelizer(box, edge);
    for (const Triangle& triangle : triangles) voxelizer.add(triangle);
    return voxelizer.voxels();
}

}  // namespace praxis::tamp
