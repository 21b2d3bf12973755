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

#include "tamp/geometry/point_triangle.hpp"
#include "tamp/scenes/occupancy_map.hpp"
#include "tamp/scenes/voxelize.hpp"

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

AxisBox triangle_box(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const Vector3& first = mesh.vertices[a];
    const Vector3& second = mesh.vertices[b];
    const Vector3& third = mesh.vertices[c];
    return {first.cwiseMin(second).cwiseMin(third), first.cwiseMax(second).cwiseMax(third)};
}

std::shared_ptr<const MeshTriangles> triangles_of(const std::shared_ptr<const Mesh>& pointer) {
    const Mesh& mesh = *pointer;
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
    std::vector<AxisBox> boxes;
    boxes.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) boxes.push_back(triangle_box(mesh, triangle));
    return std::make_shared<const MeshTriangles>(
        MeshTriangles{mesh.vertices, mesh.triangles, BoxTree(boxes), std::move(model)});
}

std::shared_ptr<const MapBoxes> boxes_of(const std::shared_ptr<const OccupancyMap>& map) {
    return std::make_shared<const MapBoxes>(MapBoxes{map->boxes(), BoxTree(map->boxes())});
}

Solid solid_of(std::shared_ptr<const MeshTriangles> mesh) {
    Solid solid;
    solid.extent = mesh->tree.bound();
    solid.geometry = mesh->geometry;
    solid.mesh = std::move(mesh);
    return solid;
}

Solid solid_of(std::shared_ptr<const MapBoxes> map) {
    Solid solid;
    if (!map->tree.empty()) solid.extent = map->tree.bound();
    solid.map = std::move(map);
    return solid;
}

bool collide(const fcl::CollisionGeometryd& first, const Pose& first_pose,
             const fcl::CollisionGeometryd& second, const Pose& second_pose) {
    const fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    return fcl::collide(&first, first_pose, &second, second_pose, request, result) > 0;
}

/// Calls `visit` with the boxes of a map (and where they stand) that the other's box overlaps, until it
/// returns true.
template <class Visit>
bool any_box(const Solid& map, const Pose& map_pose, const AxisBox& other, const Pose& other_pose,
             Visit&& visit) {
    const AxisBox around = moved(other, map_pose.inverse() * other_pose);
    return map.map->tree.any_of(around, [&](std::size_t index) {
        const AxisBox& box = map.map->boxes[index];
        return visit(box, map_pose * Eigen::Translation3d(box.center()));
    });
}

bool touch_map(const Solid& map, const Pose& map_pose, const Solid& other, const Pose& other_pose) {
    if (other.radius >= 0) {
        const Vector3 center = map_pose.inverse() * other_pose.translation();
        return map.map->tree.any_of(box_around(center, other.radius), [&](std::size_t index) {
            return map.map->boxes[index].squared_distance(center) <= other.radius * other.radius;
        });
    }
    return any_box(map, map_pose, other.extent, other_pose, [&](const AxisBox& box, const Pose& pose) {
        const fcl::Boxd geometry(box.size());
        if (!other.map) return collide(geometry, pose, *other.geometry, other_pose);
        const AxisBox extent = {-0.5 * box.size(), 0.5 * box.size()};
        return any_box(other, other_pose, extent, pose, [&](const AxisBox& second, const Pose& second_pose) {
            return collide(geometry, pose, fcl::Boxd(second.size()), second_pose);
        });
    });
}

/// FCL sees contacts of balls and triangles that are centimetres apart; distances do not.
bool touch_mesh(const MeshTriangles& mesh, const Pose& mesh_pose, const Vector3& center, double radius) {
    const Vector3 point = mesh_pose.inverse() * center;
    return mesh.tree.any_of(box_around(point, radius), [&](std::size_t index) {
        const auto& [a, b, c] = mesh.triangles[index];
        return squared_distance(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]) <=
               radius * radius;
    });
}

}  // namespace

bool touch(const Solid& first, const Pose& first_pose, const Solid& second, const Pose& second_pose) {
    if (first.radius >= 0 && second.radius >= 0) {
        const double reach = first.radius + second.radius;
        return (first_pose.translation() - second_pose.translation()).squaredNorm() <= reach * reach;
    }
    if (first.map) return touch_map(first, first_pose, second, second_pose);
    if (second.map) return touch_map(second, second_pose, first, first_pose);
    if (first.mesh && second.radius >= 0) {
        return touch_mesh(*first.mesh, first_pose, second_pose.translation(), second.radius);
    }
    if (second.mesh && first.radius >= 0) {
        return touch_mesh(*second.mesh, second_pose, first_pose.translation(), first.radius);
    }
    return collide(*first.geometry, first_pose, *second.geometry, second_pose);
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

template <class From, class Made>
template <class Make>
std::shared_ptr<const Made> SolidCache::Kept<From, Made>::get(const std::shared_ptr<const From>& from,
                                                              Make&& make) {
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(from.get());
    if (found != entries_.end() && !found->second.from.expired()) return found->second.made;
    std::erase_if(entries_, [](const auto& item) { return item.second.from.expired(); });
    std::shared_ptr<const Made> made = make(from);
    entries_.emplace(from.get(), Entry{from, made});
    return made;
}

std::vector<Solid> SolidCache::make(const std::vector<PlacedShape>& shapes) {
    std::vector<Solid> solids;
    solids.reserve(shapes.size());
    for (const PlacedShape& placed : shapes) {
        if (!is_finite(placed.pose)) throw std::invalid_argument("the pose of a shape is not finite");
        Solid solid = std::visit(
            [&]<class Kind>(const Kind& shape) {
                if constexpr (std::is_same_v<Kind, std::shared_ptr<const Mesh>>) {
                    if (!shape) throw std::invalid_argument("a shape has no mesh");
                    return solid_of(meshes_.get(shape, triangles_of));
                } else if constexpr (std::is_same_v<Kind, std::shared_ptr<const OccupancyMap>>) {
                    if (!shape) throw std::invalid_argument("a shape has no map");
                    return solid_of(maps_.get(shape, boxes_of));
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

std::shared_ptr<const DistanceGrid> SolidCache::distances(const std::shared_ptr<const Mesh>& mesh) {
    return mesh_distances_.get(mesh, [](const std::shared_ptr<const Mesh>& from) {
        constexpr double kCells = 64;  // along the longest side
        AxisBox box = triangle_box(*from, from->triangles.front());
        for (const auto& triangle : from->triangles) box.include(triangle_box(*from, triangle));
        return std::make_shared<const DistanceGrid>(voxelize(*from, box.size().maxCoeff() / kCells));
    });
}

std::shared_ptr<const DistanceGrid> SolidCache::distances(const std::shared_ptr<const OccupancyMap>& map) {
    return map_distances_.get(map, [](const std::shared_ptr<const OccupancyMap>& from) {
        return std::make_shared<const DistanceGrid>(from->obstacles());
    });
}

std::shared_ptr<const std::vector<CoveringClusters>> SolidCache::clusters(
    const std::shared_ptr<const Robot>& robot) {
    return links_.get(robot, [](const std::shared_ptr<const Robot>& from) {
        auto clusters = std::make_shared<std::vector<CoveringClusters>>();
        for (const Link& link : from->links) {
            clusters->push_back({cluster_balls(link.collision, link.balls, BallSide::outer),
                                 cluster_balls(link.collision, link.balls, BallSide::inner)});
        }
        return clusters;
    });
}

std::shared_ptr<const CoveringClusters> SolidCache::clusters(const std::shared_ptr<const BodyModel>& body) {
    return bodies_.get(body, [](const std::shared_ptr<const BodyModel>& from) {
        return std::make_shared<const CoveringClusters>(
            CoveringClusters{cluster_balls(from->shapes, from->balls, BallSide::outer),
                             cluster_balls(from->shapes, from->balls, BallSide::inner)});
    });
}

}  // namespace praxis::tamp
