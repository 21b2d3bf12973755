// Solid shapes, each in a frame of its own whose origin is the centre (of a mesh: the file's origin).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

class OccupancyMap;

struct Sphere {
    double radius = 0;
};

struct Box {
    Vector3 size = Vector3::Zero();  ///< whole side lengths along x, y, z
};

/// Along z, from -length/2 to length/2.
struct Cylinder {
    double radius = 0;
    double length = 0;
};

/// Along z: all points within `radius` of the segment from -length/2 to length/2.
struct Capsule {
    double radius = 0;
    double length = 0;
};

/// A triangle soup. Solid only for drawing: collision sees the surface.
struct Mesh {
    std::string name = {};  ///< the file, for messages
    std::vector<Vector3> vertices = {};
    std::vector<std::array<std::uint32_t, 3>> triangles = {};
};

/// Occupied space in voxels (OctoMap, point clouds); see scenes/occupancy_map.hpp.
using Shape = std::variant<Sphere, Box, Cylinder, Capsule, std::shared_ptr<const Mesh>,
                           std::shared_ptr<const OccupancyMap>>;

struct PlacedShape {
    Pose pose = Pose::Identity();  ///< in the frame of the link or body
    Shape shape = {};
};

/// A ball of a link or body: a part of a cover of its shapes.
struct Ball {
    Vector3 center = Vector3::Zero();
    double radius = 0;
};

}  // namespace praxis::tamp
