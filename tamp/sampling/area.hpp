// Where things may be put: a surface or region of a scene, on its own.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "tamp/scenes/scene.hpp"

namespace praxis::tamp {

/// A rectangle around the origin of its frame, z away from what carries it.
struct Area {
    std::string name = {};
    int body = -1;                    ///< that it is on, and moves with; -1: the world
    Pose pose = Pose::Identity();     ///< in that body, or in the world
    std::array<double, 2> size = {};  ///< whole side lengths along x and y
};

/// The area's frame in the world.
inline Pose area_pose(const World& world, const Area& area) {
    return area.body < 0 ? area.pose : world[area.body].pose * area.pose;
}

/// All regions and surfaces of a scene; where a region and a surface have one name, the region.
std::map<std::string, Area, std::less<>> areas_of(const Scene& scene);

}  // namespace praxis::tamp
