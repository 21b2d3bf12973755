// What a refinement found, as one value: the robot and the bodies as pictures show them, the plan, its
// motion in time, and what was tried in vain. It stands alone: it needs no robot file and no scene, and
// poses are kept as the seven numbers that files hold, so that what is read back is exactly what was
// written.
//
// `describe.hpp` makes its parts from robots, worlds and trajectories; `document_json.hpp` writes and reads
// it; `replay.hpp` says where everything is at a time; `csv.hpp` and `joint_trajectory.hpp` write it for
// other programs; `view/trajectory_page.hpp` shows it. docs/trajectory-format.md is the format.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tamp/geometry/shape.hpp"
#include "tamp/motion/path.hpp"
#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Lengths in metres, angles in radians, times in seconds from the start. Links, bodies and variables have
/// distinct names. `check_document` says what else holds.
struct TrajectoryDocument {
    /// x y z, then the quaternion qx qy qz qw with qw >= 0 (see `to_numbers`).
    using PoseNumbers = std::array<double, 7>;
    static constexpr PoseNumbers kIdentity = {0, 0, 0, 0, 0, 0, 1};

    /// Cubes along the axes of the link or body.
    struct Voxels {
        double edge = 0;
        std::vector<Vector3> centers = {};
    };
    struct PlacedShape {
        PoseNumbers pose = kIdentity;  ///< in the link or body
        std::variant<Sphere, Box, Cylinder, Capsule, std::shared_ptr<const Mesh>, Voxels> shape = {};
    };

    struct Link {
        std::string name = {};
        int parent = -1;                 ///< a link before this one; -1: link 0
        PoseNumbers origin = kIdentity;  ///< of the joint frame in the parent
        JointType type = JointType::fixed;
        std::array<double, 3> axis = {0, 0, 1};  ///< in the joint frame
        int variable = -1;                       ///< -1: does not move
        double multiplier = 1;
        double offset = 0;
        std::vector<PlacedShape> shapes = {};
    };
    struct Tool {
        std::string name = {};
        int link = 0;
        PoseNumbers pose = kIdentity;  ///< of the tool frame in the link
    };
    struct Robot {
        std::string name = {};
        PoseNumbers base = kIdentity;  ///< of link 0 in the world
        std::vector<std::string> variables = {};
        std::vector<Link> links = {};
        std::vector<Tool> tools = {};
    };

    /// A body in a link's frame, by their names.
    struct Hold {
        std::string body = {};
        std::string link = {};
        PoseNumbers pose = kIdentity;  ///< of the body in the link
    };
    /// A body in the world, by its name.
    struct Stand {
        std::string body = {};
        PoseNumbers pose = kIdentity;
    };
    struct Body {
        std::string name = {};
        PoseNumbers pose = kIdentity;  ///< at time 0, in the world
        std::vector<PlacedShape> shapes = {};
        std::array<double, 3> color = {0.7, 0.7, 0.7};  ///< red, green, blue in [0, 1]
        bool movable = false;
    };

    struct Action {
        std::string name = {};
        std::vector<std::string> arguments = {};
        double start = 0;
        double end = 0;
    };
    /// A continuous parameter.
    struct Value {
        std::string kind = {};  ///< "pose", "grasp", "configuration", "trajectory", ...
        std::vector<double> numbers = {};
    };

    enum class Motion : std::uint8_t { transit, transfer, approach, retreat, gripper, base, wait };
    struct Segment {
        int action = 0;  ///< index into `plan`
        Motion kind = Motion::transit;
        double start = 0;
        double end = 0;
        std::vector<int> variables = {};  ///< those that move; nothing else moves them meanwhile
        /// None, or the first at `start` and the last at `end`; times from the start of the document.
        std::vector<Trajectory::Knot> knots = {};
        /// What happens at the end; at most one of the two.
        std::optional<Hold> attach = {};
        std::optional<Stand> detach = {};
    };

    enum class Reason : std::uint8_t { collision, kinematics, no_path, other };
    struct Attempt {
        std::string action = {};  ///< "(pick can4 ...)"
        std::string stream = {};
        Reason reason = Reason::other;
        std::string message = {};
        Configuration configuration = {};   ///< of the whole robot; empty: not known
        std::optional<Hold> held = {};      ///< what the robot held
        std::vector<Stand> elsewhere = {};  ///< bodies that did not stand as at time 0
        std::vector<std::pair<std::string, std::string>> contacts = {};  ///< links or bodies
        int count = 1;                                                   ///< how often
    };

    Robot robot = {};
    std::vector<Body> bodies = {};
    std::vector<Hold> held = {};  ///< what the robot holds at time 0
    Configuration start = {};     ///< of the whole robot at time 0
    std::vector<Action> plan = {};
    std::map<std::string, Value> values = {};  ///< the continuous parameters by name
    std::vector<Segment> segments = {};        ///< in order of `start`
    std::vector<Attempt> attempts = {};
    std::map<std::string, double> statistics = {};

    /// When the last action and the last segment have ended.
    double duration() const;
    /// -1 if there is none.
    int find_link(const std::string& name) const;
    int find_body(const std::string& name) const;
};

/// Throws std::invalid_argument, naming the member ("segments[3].knots[2].q") and what it must be, if sizes,
/// indices, names, times or numbers do not fit together.
void check_document(const TrajectoryDocument& document);

}  // namespace praxis::tamp
