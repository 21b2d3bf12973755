// A scene: the robot where it starts, the world around it, and what its places and things are called.
//
// Vocabulary. A *surface* is a rectangle on a body (or in the world: a floor) where things can be placed; a
// *region* is a rectangle within a surface that a task speaks of. Bodies, surfaces and regions are known to
// PDDL by name. Scenes are read from files (`scene_file.hpp`, docs/scene-format.md) or filled in by programs.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A rectangle in the plane z = 0 of its own frame, around the origin; z points away from what carries it.
struct Surface {
    std::string name = {};
    int body = -1;                    ///< -1: the world
    Pose pose = Pose::Identity();     ///< in the body's frame, or the world's
    std::array<double, 2> size = {};  ///< whole side lengths along x and y
};

/// A rectangle within a surface.
struct Region {
    std::string name = {};
    int surface = 0;
    Pose pose = Pose::Identity();     ///< in the surface's frame: moved and turned in its plane
    std::array<double, 2> size = {};  ///< whole side lengths
};

/// Ways to take hold of a body with a gripper of two fingers.
enum class GraspKind : std::uint8_t { top, side };

struct Scene {
    std::shared_ptr<const Robot> robot = {};
    WorldPointer world = std::make_shared<const World>();
    Configuration start = {};  ///< of the whole robot
    std::vector<Surface> surfaces = {};
    std::vector<Region> regions = {};
    std::map<std::string, int, std::less<>> objects = {};  ///< name in PDDL -> body
    std::map<std::string, Pose, std::less<>> poses = {};   ///< in the world, by name in PDDL
    std::map<int, std::vector<GraspKind>> grasps = {};     ///< by body; not there: all kinds
    std::map<std::string, std::string, std::less<>> stream_options = {};
    Vector3 gravity = {0, 0, -9.81};

    /// -1 if there is none.
    int find_surface(std::string_view name) const;
    int find_region(std::string_view name) const;
};

/// Placed bodies hover by this much, metres: touching counts as a collision.
inline constexpr double kPlacementGap = 5e-4;

/// In the world, now. A surface on an attached body is where its link is at the start.
Pose surface_pose(const Scene& scene, int surface);

/// Where a body stands upright on a surface: its lowest point `kPlacementGap` above it, its origin over
/// (`x`, `y`) of the surface's frame, turned by `yaw` about the surface's normal. In the world.
Pose placement(const Scene& scene, const BodyModel& body, int surface, double x, double y, double yaw);

/// What is wrong with the start: variables out of their limits; links and attached bodies in collision, with
/// whom; bodies that can be moved in collision with others. One sentence each; empty: all is well. Bodies
/// that are not movable may overlap one another.
std::vector<std::string> check_scene(const Scene& scene);

}  // namespace praxis::tamp
