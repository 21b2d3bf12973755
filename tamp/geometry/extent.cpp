#include "tamp/geometry/extent.hpp"

namespace praxis::tamp {

namespace {

struct Include {
    const Pose& pose;
    Extent& extent;

    void include(const Vector3& half) const {
        extent.include(pose.translation() - half);
        extent.include(pose.translation() + half);
    }

    void operator()(const Sphere& sphere) const { include(Vector3::Constant(sphere.radius)); }
    void operator()(const Box& box) const { include(pose.linear().cwiseAbs() * (box.size / 2)); }
    void operator()(const Cylinder& cylinder) const {
        // A disc of normal n reaches r * sqrt(1 - n_i^2) along axis i.
        const Vector3 axis = pose.linear().col(2);
        const Vector3 disc = (Vector3::Ones() - axis.cwiseAbs2()).cwiseMax(0).cwiseSqrt() * cylinder.radius;
        include(disc + axis.cwiseAbs() * (cylinder.length / 2));
    }
    void operator()(const Capsule& capsule) const {
        const Vector3 axis = pose.linear().col(2);
        include(axis.cwiseAbs() * (capsule.length / 2) + Vector3::Constant(capsule.radius));
    }
    void operator()(const std::shared_ptr<const Mesh>& mesh) const {
        for (const Vector3& vertex : mesh->vertices) extent.include(pose * vertex);
    }
    void operator()(const std::shared_ptr<const OccupancyMap>&) const {}
};

}  // namespace

Extent extent_of(std::span<const PlacedShape> shapes, const Pose& pose) {
    Extent extent;
    for (const PlacedShape& placed : shapes) {
        const Pose shape_pose = pose * placed.pose;
        std::visit(Include{shape_pose, extent}, placed.shape);
    }
    return extent;
}

}  // namespace praxis::tamp
