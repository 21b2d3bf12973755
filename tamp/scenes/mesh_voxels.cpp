#include "tamp/scenes/mesh_voxels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace praxis::tamp {

namespace {

using Corners = std::array<Vector3, 3>;

void require_valid(const Mesh& mesh, int resolution) {
    if (resolution < 1 || resolution > 256) throw std::invalid_argument("a resolution must be from 1 to 256");
    if (mesh.triangles.empty()) throw std::invalid_argument("mesh '" + mesh.name + "' has no triangles");
    if (!std::ranges::all_of(mesh.vertices, [](const Vector3& vertex) { return vertex.allFinite(); })) {
        throw std::invalid_argument("mesh '" + mesh.name + "' has a vertex that is not finite");
    }
    for (const auto& [a, b, c] : mesh.triangles) {
        if (std::max({a, b, c}) >= mesh.vertices.size()) {
            throw std::invalid_argument("mesh '" + mesh.name +
                                        "' has a triangle with a vertex that is not there");
        }
    }
}

Vector3 lower_corner(const Corners& triangle) {
    return triangle[0].cwiseMin(triangle[1]).cwiseMin(triangle[2]);
}

Vector3 upper_corner(const Corners& triangle) {
    return triangle[0].cwiseMax(triangle[1]).cwiseMax(triangle[2]);
}

class Voxeliser {
  public:
    Voxeliser(const Mesh& mesh, int resolution) {
        Vector3 lower = mesh.vertices[mesh.triangles[0][0]];
        Vector3 upper = lower;
        for (const auto& triangle : mesh.triangles) {
            const Corners corners = corners_of(mesh, triangle);
            lower = lower.cwiseMin(lower_corner(corners));
            upper = upper.cwiseMax(upper_corner(corners));
        }
        constexpr double kLeastEdge = 1e-6;
        VoxelGrid& grid = voxels_.grid;
        grid.edge = std::max((upper - lower).maxCoeff() / resolution, kLeastEdge);
        for (int i = 0; i < 3; ++i) {
            const std::size_t axis = static_cast<std::size_t>(i);
            grid.cells[axis] = static_cast<int>((upper[i] - lower[i]) / grid.edge) + 2;
            grid.origin[axis] = (lower[i] + upper[i] - grid.cells[axis] * grid.edge) / 2;
        }
        voxels_.filled.assign(grid.size(), 0);
        for (const auto& triangle : mesh.triangles) fill(corners_of(mesh, triangle));
    }

    VoxelSet take() { return std::move(voxels_); }

  private:
    static Corners corners_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
        return {mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]};
    }

    int cell(double coordinate, int axis) const {
        const std::size_t a = static_cast<std::size_t>(axis);
        const double place = std::floor((coordinate - voxels_.grid.origin[a]) / voxels_.grid.edge);
        return std::clamp(static_cast<int>(place), 0, voxels_.grid.cells[a] - 1);
    }

    /// Halves the triangle at its longest side until its box is no larger than a voxel, then fills what the
    /// box touches.
    void fill(const Corners& whole) {
        open_.assign(1, whole);
        while (!open_.empty()) {
            const Corners triangle = open_.back();
            open_.pop_back();
            const Vector3 lower = lower_corner(triangle);
            const Vector3 upper = upper_corner(triangle);
            if ((upper - lower).maxCoeff() > voxels_.grid.edge) {
                halve(triangle);
            } else {
                fill_box(lower, upper);
            }
        }
    }

    void halve(const Corners& triangle) {
        std::size_t longest = 0;
        double length = -1;
        for (std::size_t i = 0; i < 3; ++i) {
            const double side = (triangle[i] - triangle[(i + 1) % 3]).squaredNorm();
            if (side > length) {
                length = side;
                longest = i;
            }
        }
        const Vector3& from = triangle[longest];
        const Vector3& to = triangle[(longest + 1) % 3];
        const Vector3& third = triangle[(longest + 2) % 3];
        const Vector3 middle = 0.5 * (from + to);
        open_.push_back({from, middle, third});
        open_.push_back({middle, to, third});
    }

    void fill_box(const Vector3& lower, const Vector3& upper) {
        for (int k = cell(lower.z(), 2); k <= cell(upper.z(), 2); ++k) {
            for (int j = cell(lower.y(), 1); j <= cell(upper.y(), 1); ++j) {
                for (int i = cell(lower.x(), 0); i <= cell(upper.x(), 0); ++i) {
                    voxels_.filled[voxels_.grid.index(i, j, k)] = 1;
                }
            }
        }
    }

    VoxelSet voxels_ = {};
    std::vector<Corners> open_ = {};
};

}  // namespace

VoxelSet voxels_of(const Mesh& mesh, int resolution) {
    require_valid(mesh, resolution);
    return Voxeliser(mesh, resolution).take();
}

}  // namespace praxis::tamp
