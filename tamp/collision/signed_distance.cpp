#include "tamp/collision/signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace praxis::tamp {

namespace {

struct Distance {
    const Vector3& point;

    double operator()(const Sphere& sphere) const { return point.norm() - sphere.radius; }
    double operator()(const Box& box) const { return (point.cwiseAbs() - box.size / 2).maxCoeff(); }
    double operator()(const Cylinder& cylinder) const {
        return std::max(std::hypot(point.x(), point.y()) - cylinder.radius,
                        std::abs(point.z()) - cylinder.length / 2);
    }
    double operator()(const Capsule& capsule) const {
        const double along = std::max(std::abs(point.z()) - capsule.length / 2, 0.0);
        return std::hypot(point.x(), point.y(), along) - capsule.radius;
    }
    double operator()(const std::shared_ptr<const Mesh>&) const { return infinite(); }
    double operator()(const std::shared_ptr<const OccupancyMap>&) const { return infinite(); }

    static double infinite() { return std::numeric_limits<double>::infinity(); }
};

}  // namespace

double signed_distance(const Shape& shape, const Vector3& point) {
    return std::visit(Distance{point}, shape);
}

}  // namespace praxis::tamp
