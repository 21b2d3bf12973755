#include "tamp/collision/solid.hpp"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

using GeometryPointer = std::shared_ptr<const fcl::CollisionGeometryd>;

double require_length(double number, const char* what) {
    if (!std::isfinite(number) || number <= 0) {
        throw std::invalid_argument(std::string(what) + " of a shape must be above 0 and finite, not " +
                                    std::to_string(number));
    }
    return number;
}

AxisBox centered(double x, double y, double z) {
    return {{-0.5 * x, -0.5 * y, -0.5 * z}, {0.5 * x, 0.5 * y, 0.5 * z}};
}

Solid solid_of(const Sphere& sphere) {
    Solid solid;
    solid.radius = require_length(sphere.radius, "the radius");
    solid.geometry = std::make_shared<fcl::Sphered>(sphere.radius);
    solid.extent = centered(2 * sphere.radius, 2 * sphere.radius, 2 * sphere.radius);
    return solid;
}

Solid solid_of(const Box& box) {
    for (int i = 0; i < 3; ++i) require_length(box.size[i], "the size");
    Solid solid;
    solid.geometry = std::make_shared<fcl::Boxd>(box.size);
    solid.extent = centered(box.size.x(), box.size.y(), box.size.z());
    return solid;
}

Solid solid_of(const Cylinder& cylinder) {
    require_length(cylinder.radius, "the radius");
    require_length(cylinder.length, "the length");
    Solid solid;
    solid.geometry = std::make_shared<fcl::Cylinderd>(cylinder.radius, cylinder.length);
    solid.extent = centered(2 * cylinder.radius, 2 * cylinder.radius, cylinder.length);
    return solid;
}

Solid solid_of(const Capsule& capsule) {
    require_length(capsule.radius, "the radius");
    require_length(capsule.length, "the length");
    Solid solid;
    solid.geometry = std::make_shared<fcl::Capsuled>(capsule.radius, capsule.length);
    solid.extent = centered(2 * capsule.radius, 2 * capsule.radius, capsule.length + 2 * capsule.radius);
    return solid;
}

GeometryPointer triangles_of(const Mesh& mesh) {
    const auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
    std::vector<fcl::Triangle> triangles;
    triangles.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        if (std::max({a, b, c}) >= mesh.vertices.size()) {
            throw std::invalid_argument("mesh '" + mesh.name +
                                        "' has a triangle with a vertex that is not there");
        }
        triangles.emplace_back(a, b, c);
    }
    if (triangles.empty()) throw std::invalid_argument("mesh '" + mesh.name + "' has no triangles");
    if (!std::ranges::all_of(mesh.vertices, [](const Vector3& vertex) { return vertex.allFinite(); })) {
        throw std::invalid_argument("mesh '" + mesh.name + "' has a vertex that is not finite");
    }
    model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
    model->addSubModel(mesh.vertices, triangles);
    model->endModel();
    model->computeLocalAABB();
    return model;
}

Solid solid_of(GeometryPointer mesh) {
    Solid solid;
    solid.extent = {mesh->aabb_local.min_, mesh->aabb_local.max_};
    solid.geometry = std::move(mesh);
    return solid;
}

}  // namespace

bool touch(const Solid& first, const Pose& first_pose, const Solid& second, const Pose& second_pose) {
    if (first.radius >= 0 && second.radius >= 0) {
        const double reach = first.radius + second.radius;
        return (first_pose.translation() - second_pose.translation()).squaredNorm() <= reach * reach;
    }
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(first.geometry.get(), first_pose, second.geometry.get(), second_pose, request,
                        result) > 0;
}

Ball bound_of(const std::vector<Solid>& solids) {
    if (solids.empty()) return {};
    AxisBox box = box_around(solids.front().bound.center, solids.front().bound.radius);
    for (const Solid& solid : solids) box.include(box_around(solid.bound.center, solid.bound.radius));
    Ball ball = {box.center(), 0};
    for (const Solid& solid : solids) {
        ball.radius = std::max(ball.radius, (solid.bound.center - ball.center).norm() + solid.bound.radius);
    }
    return ball;
}

std::vector<Solid> SolidCache::make(const std::vector<PlacedShape>& shapes) {
    std::vector<Solid> solids;
    solids.reserve(shapes.size());
    for (const PlacedShape& placed : shapes) {
        if (!is_finite(placed.pose)) throw std::invalid_argument("the pose of a shape is not finite");
        Solid solid = std::visit(
            [&]<class Kind>(const Kind& shape) {
                if constexpr (std::is_same_v<Kind, std::shared_ptr<const Mesh>>) {
                    return solid_of(of_mesh(shape));
                } else if constexpr (std::is_same_v<Kind, std::shared_ptr<const OccupancyMap>>) {
                    throw std::invalid_argument("maps cannot be checked");
                    return Solid{};
                } else {
                    return solid_of(shape);
                }
            },
            placed.shape);
        solid.pose = placed.pose;
        solid.bound.center = placed.pose * solid.extent.center();
        solid.bound.radius = solid.radius >= 0 ? solid.radius : 0.5 * solid.extent.size().norm();
        solids.push_back(std::move(solid));
    }
    return solids;
}

GeometryPointer SolidCache::of_mesh(const std::shared_ptr<const Mesh>& mesh) {
    if (!mesh) throw std::invalid_argument("a shape has no mesh");
    const std::scoped_lock lock(mutex_);
    std::erase_if(meshes_, [](const auto& item) { return item.second.mesh.expired(); });
    const auto found = meshes_.find(mesh.get());
    if (found != meshes_.end()) return found->second.geometry;
    GeometryPointer geometry = triangles_of(*mesh);
    meshes_.emplace(mesh.get(), Entry{mesh, geometry});
    return geometry;
}

}  // namespace praxis::tamp
