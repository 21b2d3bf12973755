#include "tamp/scenes/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "tamp/collision/body_checker.hpp"
#include "tamp/collision/fcl_checker.hpp"
#include "tamp/geometry/extent.hpp"

namespace praxis::tamp {

namespace {

template <class T>
int find_named(const std::vector<T>& items, std::string_view name) {
    const auto found = std::ranges::find(items, name, &T::name);
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

std::string name_of(const Scene& scene, const Participant& participant) {
    if (participant.kind == Participant::Kind::body) {
        return "body '" + (*scene.world)[participant.index].model->name + "'";
    }
    return "link '" + scene.robot->links[static_cast<std::size_t>(participant.index)].name + "'";
}

void check_limits(const Scene& scene, std::vector<std::string>& problems) {
    constexpr double kTolerance = 1e-9;
    for (std::size_t i = 0; i < scene.robot->variables.size(); ++i) {
        const Variable& variable = scene.robot->variables[i];
        const double position = scene.start[i];
        if (position >= variable.lower - kTolerance && position <= variable.upper + kTolerance) continue;
        problems.push_back("the start of '" + variable.name + "' is " + std::to_string(position) +
                           ", outside of its limits " + std::to_string(variable.lower) + " to " +
                           std::to_string(variable.upper));
    }
}

void check_robot_contacts(const Scene& scene, const std::shared_ptr<SolidCache>& cache,
                          std::vector<std::string>& problems) {
    if (scene.robot->groups.empty()) return;
    const auto checker = make_fcl_checker({scene.robot, scene.world, 0, scene.start}, cache);
    std::vector<Contact> contacts;
    checker->find_contacts(scene.robot->extract(scene.robot->groups[0], scene.start), contacts);
    for (const Contact& contact : contacts) {
        problems.push_back(name_of(scene, contact.first) + " touches " + name_of(scene, contact.second) +
                           " at the start; move one of them, or list the pair in allowed_collisions");
    }
}

void check_body_contacts(const Scene& scene, const std::shared_ptr<SolidCache>& cache,
                         std::vector<std::string>& problems) {
    const World& world = *scene.world;
    const BodyChecker checker(scene.world, cache);
    for (int body = 0; static_cast<std::size_t>(body) < world.size(); ++body) {
        if (!world[body].model->movable || world[body].attachment) continue;
        for (const int other : checker.contacts(body, world[body].pose)) {
            if (world[other].model->movable && other < body) continue;
            problems.push_back("body '" + world[body].model->name + "' touches body '" +
                               world[other].model->name +
                               "' at the start; move one of them, or list the pair in allowed_collisions");
        }
    }
}

}  // namespace

int Scene::find_surface(std::string_view name) const {
    return find_named(surfaces, name);
}

int Scene::find_region(std::string_view name) const {
    return find_named(regions, name);
}

Pose surface_pose(const Scene& scene, int surface) {
    const Surface& top = scene.surfaces.at(static_cast<std::size_t>(surface));
    if (top.body < 0) return top.pose;
    const BodyState& body = (*scene.world)[top.body];
    if (!body.attachment) return body.pose * top.pose;
    return link_pose(*scene.robot, scene.start, body.attachment->link) * body.attachment->in_link * top.pose;
}

Pose placement(const Scene& scene, const BodyModel& body, int surface, double x, double y, double yaw) {
    const double height = kPlacementGap - extent(body.shapes).lower.z();
    return surface_pose(scene, surface) * pose_from_rpy({x, y, height}, {0, 0, yaw});
}

std::vector<std::string> check_scene(const Scene& scene) {
    if (!scene.robot || !scene.world) throw std::invalid_argument("a scene needs a robot and a world");
    if (scene.start.size() != scene.robot->dimension()) {
        throw std::invalid_argument("a scene's start needs one number a variable of its robot");
    }
    std::vector<std::string> problems;
    const auto cache = make_solid_cache();
    check_limits(scene, problems);
    check_robot_contacts(scene, cache, problems);
    check_body_contacts(scene, cache, problems);
    return problems;
}

}  // namespace praxis::tamp
