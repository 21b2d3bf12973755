#include "tamp/geometry/extent.hpp"

#include <cmath>
#include <stdexcept>

#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {

namespace {

AxisBox around(const Vector3& half, const Pose& pose) {
    return {pose.translation() - half, pose.translation() + half};
}

struct Measure {
    const Pose& pose;

    AxisBox operator()(const Sphere& sphere) const { return around(Vector3::Constant(sphere.radius), pose); }
    AxisBox operator()(const Box& box) const { return moved({-0.5 * box.size, 0.5 * box.size}, pose); }
    AxisBox operator()(const Cylinder& cylinder) const {
        const Vector3 axis = pose.linear().col(2);
        const Vector3 across = (1 - axis.array().square()).max(0).sqrt();
        return around(0.5 * cylinder.length * axis.cwiseAbs() + cylinder.radius * across, pose);
    }
    AxisBox operator()(const Capsule& capsule) const {
        const Vector3 axis = pose.linear().col(2);
        return around((0.5 * capsule.length * axis.cwiseAbs()).array() + capsule.radius, pose);
    }
    AxisBox operator()(const std::shared_ptr<const Mesh>& mesh) const {
        if (!mesh || mesh->vertices.empty())
            throw std::invalid_argument("a mesh without vertices has no extent");
        const Vector3 first = pose * mesh->vertices.front();
        AxisBox box = {first, first};
        for (const Vector3& vertex : mesh->vertices) box.include({pose * vertex, pose * vertex});
        return box;
    }
    AxisBox operator()(const std::shared_ptr<const OccupancyMap>& map) const {
        const VoxelGrid& grid = map->grid();
        const Vector3 lower(grid.origin[0], grid.origin[1], grid.origin[2]);
        const Vector3 cells(grid.cells[0], grid.cells[1], grid.cells[2]);
        return moved({lower, lower + grid.edge * cells}, pose);
    }
};

}  // namespace

AxisBox extent(const PlacedShape& shape, const Pose& pose) {
    const Pose placed = pose * shape.pose;
    return std::visit(Measure{placed}, shape.shape);
}

AxisBox extent(std::span<const PlacedShape> shapes, const Pose& pose) {
    if (shapes.empty()) throw std::invalid_argument("nothing has no extent");
    AxisBox box = extent(shapes.front(), pose);
    for (const PlacedShape& shape : shapes.subspan(1)) box.include(extent(shape, pose));
    return box;
}

}  // namespace praxis::tamp
