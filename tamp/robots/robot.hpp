// A robot: a tree of links, joined by joints, with the groups of joints that are planned for.
//
// Vocabulary. A *variable* is one degree of freedom; a *configuration* has one number a variable of the whole
// robot, in the order of `variables`. A joint's position is `multiplier * q[variable] + offset` (a mimic
// joint shares its master's variable). A *group* is what one motion moves: a list of variables (an arm, a
// gripper, a mobile base), with the link at its tip. A mobile base is three joints: prismatic x, prismatic y,
// continuous yaw; so SE(2) needs nothing of its own.
//
// Links and joints are stored parents first: link 0 is the root, fixed in the world at `Robot::base`; joint i
// joins a link with a smaller number to link `child`. Robots are immutable once made and shared between
// threads. Limits: 64 links, 32 variables, 16 variables a group.
//
// Robots are read from URDF and SRDF (`robots/urdf.hpp`), made from Denavit-Hartenberg tables
// (`robots/dh.hpp`), or taken from those built in (`robots/builtin.hpp`).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tamp/geometry/shape.hpp"

namespace praxis::tamp {

/// One number a variable: radians (revolute, continuous) or metres (prismatic).
using Configuration = std::vector<double>;

enum class JointType : std::uint8_t { fixed, revolute, continuous, prismatic };

struct Joint {
    std::string name = {};
    JointType type = JointType::fixed;
    int parent = 0;                   ///< link
    int child = 0;                    ///< link
    Pose origin = Pose::Identity();   ///< of the joint frame in the parent link's, at position 0
    Vector3 axis = Vector3::UnitZ();  ///< unit vector in the joint frame
    int variable = -1;                ///< -1: fixed
    double multiplier = 1;
    double offset = 0;
};

struct Variable {
    std::string name = {};    ///< of the joint that has it
    bool continuous = false;  ///< an angle without limits: q and q + 2 pi are the same
    double lower = -std::numeric_limits<double>::infinity();
    double upper = std::numeric_limits<double>::infinity();
    double max_velocity = 1;      ///< rad/s or m/s; > 0
    double max_acceleration = 1;  ///< rad/s^2 or m/s^2; > 0
};

struct Link {
    std::string name = {};
    int parent_joint = -1;                    ///< -1: the root
    std::vector<PlacedShape> collision = {};  ///< what must not touch
    std::vector<PlacedShape> visual = {};     ///< for pictures; empty: the collision shapes
    std::vector<Ball> balls = {};             ///< cover `collision` wholly
    Ball bound = {};                          ///< one ball around `balls` (radius 0: no geometry)
};

struct Group {
    std::string name = {};
    std::vector<int> variables = {};  ///< increasing
    int tip = -1;                     ///< link that the group carries; -1: none (a gripper)
};

struct EndEffector {
    std::string name = {};
    int link = 0;  ///< link that grasped bodies are attached to
    Pose tool =
        Pose::Identity();         ///< tool frame in `link`: z points out of the hand, y from finger to finger
    std::string arm = {};         ///< group that moves it
    std::string gripper = {};     ///< group of the fingers; may be empty
    std::vector<int> links = {};  ///< hand and fingers: may touch what is grasped
    double max_opening = 0;       ///< metres between the fingers when open
    std::optional<Configuration> open = {};  ///< positions of the gripper's variables
    std::optional<Configuration> closed = {};
};

struct NamedState {
    std::string name = {};
    std::string group = {};
    Configuration positions = {};  ///< by variable of the group
};

struct Robot {
    std::string name = {};
    Pose base = Pose::Identity();  ///< of the root link in the world
    std::vector<Link> links = {};
    std::vector<Joint> joints = {};
    std::vector<Variable> variables = {};
    std::vector<Group> groups = {};
    std::vector<EndEffector> end_effectors = {};
    std::vector<NamedState> states = {};
    /// Pairs of links (smaller number first, sorted) that are never checked against each other.
    std::vector<std::pair<int, int>> allowed_collisions = {};

    std::size_t dimension() const { return variables.size(); }
    /// Number of a link, variable or group by its name; -1 if there is none.
    int find_link(std::string_view name) const;
    int find_variable(std::string_view name) const;
    int find_group(std::string_view name) const;
    int find_end_effector(std::string_view name) const;
    bool may_collide(int first_link, int second_link) const;
    /// Every variable at 0, or at the nearer limit where 0 is outside.
    Configuration zero() const;
    /// The group's numbers out of a configuration, and back into one.
    Configuration extract(const Group& group, std::span<const double> configuration) const;
    void insert(const Group& group, std::span<const double> positions, std::span<double> configuration) const;
    /// Within the limits (with a tolerance of 1e-9) and finite.
    bool within_limits(const Group& group, std::span<const double> positions) const;
};

/// Poses of all links in the world: `poses` has one entry a link. `configuration` is one of the whole robot.
void forward_kinematics(const Robot& robot, std::span<const double> configuration, std::span<Pose> poses);
/// Pose of one link in the world.
Pose link_pose(const Robot& robot, std::span<const double> configuration, int link);

/// Throws std::invalid_argument, naming what is wrong, if indices, limits or numbers of the robot are not as
/// this header says. Readers and builders call it last.
void check_robot(const Robot& robot);

}  // namespace praxis::tamp
