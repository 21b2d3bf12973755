#include "tamp/manipulation/drives.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::tamp {

namespace {

constexpr std::size_t kMostShapes = 32;
/// Poses of all searches that are kept, together.
constexpr std::size_t kMostPoses = 4'000'000;

Configuration start_of(const SkillSpace& space) {
    const ManipulatorModel& model = space.model();
    return model.robot->extract(model.group(model.base), model.home);
}

/// As far as the base may go, a little further than there are bodies.
AxisBox extent_of(const SkillSpace& space) {
    constexpr double kMargin = 1.5;
    const ManipulatorModel& model = space.model();
    AxisBox box = space.extent();
    const std::vector<int>& variables = model.group(model.base).variables;
    for (int axis = 0; axis < 2; ++axis) {
        const Variable& variable =
            model.robot->variables[static_cast<std::size_t>(variables[static_cast<std::size_t>(axis)])];
        box.lower[axis] = std::max(box.lower[axis] - kMargin, variable.lower);
        box.upper[axis] = std::min(box.upper[axis] + kMargin, variable.upper);
    }
    return box;
}

double radius_of(const ManipulatorModel& model) {
    const Configuration base = model.robot->extract(model.group(model.base), model.home);
    const auto from_axis = [&](const Vector3& point) {
        return std::hypot(point.x() - base[0], point.y() - base[1]);
    };
    double radius = from_axis(model.tool(model.home).translation());
    for (int link = 0; link < static_cast<int>(model.robot->links.size()); ++link) {
        const Ball& ball = model.robot->links[static_cast<std::size_t>(link)].bound;
        if (ball.radius <= 0) continue;
        radius = std::max(radius,
                          from_axis(link_pose(*model.robot, model.home, link) * ball.center) + ball.radius);
    }
    return radius;
}

}  // namespace

Drives::Drives(SkillSpace& space)
    : space_(space), lattice_(start_of(space), extent_of(space)), radius_(radius_of(space.model())) {}

Drives::Shape& Drives::shape(std::optional<Id> held) {
    const auto known = shapes_.find(held);
    if (known != shapes_.end()) return known->second;
    if (shapes_.size() >= kMostShapes) {
        searches_.clear();
        shapes_.clear();
    }
    return shapes_.try_emplace(held, Shape{LatticeMap(lattice_, space_.base_checker({}, held))})
        .first->second;
}

const std::vector<BaseLattice::Pose>& Drives::taken(Shape& shape, std::optional<Id> held, Id standing) {
    const auto known = shape.taken.find(standing);
    if (known != shape.taken.end()) return known->second;
    const Ball body = space_.standing_bound(standing);
    double radius = radius_ + body.radius;
    if (held) {
        const Ball carried = space_.held_bound(*held);
        radius += carried.center.norm() + carried.radius;
    }
    const auto one = space_.base_checker(standing, held);
    return shape.taken[standing] = shape.map.touching(*one, body.center.x(), body.center.y(), radius);
}

const LatticeSearch::Way& Drives::way(const std::vector<Id>& standing, std::optional<Id> held,
                                      const Configuration& goal) {
    const std::pair key(held, standing);
    const auto known = searches_.find(key);
    if (known != searches_.end()) return known->second.to(goal);
    if ((searches_.size() + 1) * lattice_.size() > kMostPoses) searches_.clear();
    Shape& here = shape(held);
    std::vector<const std::vector<BaseLattice::Pose>*> poses;
    for (const Id one : standing) poses.push_back(&taken(here, held, one));
    return searches_.try_emplace(key, here.map, std::move(poses)).first->second.to(goal);
}

Path Drives::path(const LatticeSearch::Way& way, const Configuration& goal) const {
    Path path;
    for (const BaseLattice::Pose pose : way.poses) path.push_back(lattice_.positions(pose));
    if (path.empty() || path.back() != goal) path.push_back(goal);
    return path;
}

}  // namespace praxis::tamp
