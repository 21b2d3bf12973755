#include "tests/tamp/samples/sample_document.hpp"

#include <cmath>
#include <numbers>

#include "tamp/report/describe.hpp"

namespace praxis::tamp {

namespace {

using Motion = TrajectoryDocument::Motion;

constexpr double kShoulderHeight = 0.42;
constexpr double kArmLength = 0.45;
constexpr double kHandLength = 0.17;
constexpr double kOpen = 0.05;
constexpr double kClosed = 0.03;

Pose at(double x, double y, double z) {
    return Pose(Eigen::Translation3d(x, y, z));
}

/// Adds a link at the end of a joint of its own.
int add_link(Robot& robot, const char* name, int parent, const Pose& origin,
             std::vector<PlacedShape> shapes) {
    const int number = static_cast<int>(robot.links.size());
    Joint joint;
    joint.name = std::string(name) + "-joint";
    joint.parent = parent;
    joint.child = number;
    joint.origin = origin;
    robot.joints.push_back(joint);
    Link link;
    link.name = name;
    link.parent_joint = number - 1;
    link.collision = std::move(shapes);
    robot.links.push_back(link);
    return number;
}

int add_variable(Robot& robot, const char* name, double lower, double upper) {
    Variable variable;
    variable.name = name;
    variable.lower = lower;
    variable.upper = upper;
    robot.variables.push_back(variable);
    return static_cast<int>(robot.variables.size()) - 1;
}

void move_last(Robot& robot, JointType type, const Vector3& axis, int variable) {
    robot.joints.back().type = type;
    robot.joints.back().axis = axis;
    robot.joints.back().variable = variable;
}

std::shared_ptr<const BodyModel> model(const char* name, std::vector<PlacedShape> shapes,
                                       std::array<float, 3> color, bool movable) {
    BodyModel body;
    body.name = name;
    body.shapes = std::move(shapes);
    body.color = color;
    body.movable = movable;
    return std::make_shared<const BodyModel>(std::move(body));
}

PlacedShape box(double x, double y, double z, const Pose& pose = Pose::Identity()) {
    return {pose, Box{Vector3(x, y, z)}};
}

World sample_world() {
    std::vector<PlacedShape> shelf;
    for (const double z : {0.0, 0.38, 0.76}) shelf.push_back(box(0.36, 0.66, 0.02, at(0, 0, z)));
    for (const double y : {-0.34, 0.34}) shelf.push_back(box(0.36, 0.02, 0.78, at(0, y, 0.38)));
    World world;
    world =
        world.with_body(model("table", {box(0.5, 0.8, 0.04)}, {0.72F, 0.55F, 0.38F}, false), at(0.6, 0, 0.3));
    world = world.with_body(model("shelf", std::move(shelf), {0.45F, 0.5F, 0.58F}, false), at(0, 0.75, 0.02));
    world =
        world.with_body(model("can", {{Pose::Identity(), Cylinder{0.03, 0.12}}}, {0.1F, 0.62F, 0.5F}, true),
                        at(0.55, -0.1, 0.38));
    world = world.with_body(model("ball", {{Pose::Identity(), Sphere{0.05}}}, {0.2F, 0.55F, 0.9F}, true),
                            at(0.68, 0.2, 0.37));
    return world.with_body(model("block", {box(0.08, 0.08, 0.08)}, {0.95F, 0.75F, 0.2F}, true),
                           at(0.5, 0.25, 0.36));
}

/// To rest at `goal`: half of the time with constant acceleration, half of it with the opposite one.
Trajectory move(const Configuration& from, const Configuration& goal, double duration) {
    const std::size_t size = from.size();
    const Configuration zero(size, 0);
    Configuration middle(size), speed(size), push(size), brake(size);
    for (std::size_t i = 0; i < size; ++i) {
        push[i] = 4 * (goal[i] - from[i]) / (duration * duration);
        brake[i] = -push[i];
        speed[i] = push[i] * duration / 2;
        middle[i] = (from[i] + goal[i]) / 2;
    }
    return {{{0, from, zero, push}, {duration / 2, middle, speed, brake}, {duration, goal, zero, zero}}};
}

/// Writes the document motion by motion.
class Author {
  public:
    Author() : robot_(sample_robot()), world_(sample_world()) {
        now_ = sample_reach(Vector3(0.4, -0.3, 0.8), kOpen);
        document_ = begin_document(robot_, world_, now_);
    }

    void begin(const char* name, std::vector<std::string> arguments) {
        document_.plan.push_back({name, std::move(arguments), time_, time_});
    }

    void go(Motion kind, const Vector3& point, double duration) {
        add(0, kind, sample_reach(point, now_.back()), duration);
    }

    void grip(double finger) {
        Configuration goal = now_;
        goal.back() = finger;
        add(1, Motion::gripper, goal, 0.4);
    }

    void attach(const char* body) {
        const int number = world_.find(body);
        const int hand = robot_.find_link("hand");
        const Attachment attachment{hand, link_pose(robot_, now_, hand).inverse() * world_[number].pose, {}};
        world_ = world_.with_attached(number, attachment);
        document_.segments.back().attach = describe_hold(robot_, world_, number, attachment);
    }

    void detach(const char* body) {
        const int number = world_.find(body);
        const Attachment held = *world_[number].attachment;
        const Pose pose = link_pose(robot_, now_, held.link) * held.in_link;
        world_ = world_.with_pose(number, pose);
        document_.segments.back().detach = describe_stand(world_, number, pose);
    }

    TrajectoryDocument finish() {
        const Configuration deep = sample_reach(Vector3(0.05, 0.62, 0.72), kOpen);
        const Contact hit{{Participant::Kind::link, robot_.find_link("forearm")},
                          {Participant::Kind::body, world_.find("shelf")}};
        TrajectoryDocument::Attempt collision =
            describe_attempt(robot_, sample_world(), sample_world(), deep, {hit});
        collision.action = "(place can shelf)";
        collision.stream = "plan-place";
        collision.message = "the forearm would touch the upper board";
        collision.count = 12;
        document_.attempts.push_back(collision);
        document_.attempts.push_back({"(pick ball)",
                                      "inverse-kinematics",
                                      TrajectoryDocument::Reason::kinematics,
                                      "no configuration reaches this grasp",
                                      {},
                                      {},
                                      {},
                                      {},
                                      3});
        document_.attempts.push_back({"(place can shelf)",
                                      "plan-motion",
                                      TrajectoryDocument::Reason::no_path,
                                      "no path within 2000 samples",
                                      deep,
                                      document_.segments[2].attach,
                                      {},
                                      {{"can", "shelf"}, {"hand", "shelf"}},
                                      1});
        document_.values["#g1"] = {"grasp", {0, 0, 0.17, 0, 0, 0, 1}};
        document_.values["#p1"] = {"pose", {0.05, 0.62, 0.46, 0, 0, 0, 1}};
        document_.values["#q1"] = {"configuration", now_};
        document_.statistics["samples"] = 41;
        document_.statistics["seconds"] = 0.0123;
        return document_;
    }

  private:
    void add(std::size_t group, Motion kind, const Configuration& goal, double duration) {
        const Group& moved = robot_.groups[group];
        const int action = static_cast<int>(document_.plan.size()) - 1;
        const Trajectory trajectory =
            move(robot_.extract(moved, now_), robot_.extract(moved, goal), duration);
        document_.segments.push_back(describe_motion(moved, trajectory, action, kind, time_));
        now_ = goal;
        time_ = document_.segments.back().end;
        document_.plan.back().end = time_;
    }

    Robot robot_;
    World world_;
    Configuration now_;
    double time_ = 0;
    TrajectoryDocument document_;
};

}  // namespace

Robot sample_robot() {
    Robot robot;
    robot.name = "sample-arm";
    Link base;
    base.name = "base";
    base.collision = {{at(0, 0, 0.03), Cylinder{0.13, 0.06}}, {at(0, 0, 0.18), Cylinder{0.07, 0.26}}};
    robot.links.push_back(base);
    const int yaw = add_variable(robot, "yaw", -std::numbers::pi, std::numbers::pi);
    const int shoulder = add_variable(robot, "shoulder", -std::numbers::pi, std::numbers::pi);
    const int elbow = add_variable(robot, "elbow", -std::numbers::pi, std::numbers::pi);
    const int wrist = add_variable(robot, "wrist", -2 * std::numbers::pi, 2 * std::numbers::pi);
    const int finger = add_variable(robot, "finger", 0, kOpen);
    const Vector3 y = Vector3::UnitY(), z = Vector3::UnitZ();

    const int turret =
        add_link(robot, "turret", 0, at(0, 0, kShoulderHeight), {{at(0, 0, -0.06), Cylinder{0.075, 0.12}}});
    move_last(robot, JointType::revolute, z, yaw);
    const int upper = add_link(robot, "upper-arm", turret, Pose::Identity(),
                               {{at(0, 0, kArmLength / 2), Capsule{0.055, kArmLength}}});
    move_last(robot, JointType::revolute, y, shoulder);
    const int forearm = add_link(robot, "forearm", upper, at(0, 0, kArmLength),
                                 {{at(0, 0, kArmLength / 2), Capsule{0.045, kArmLength}}});
    move_last(robot, JointType::revolute, y, elbow);
    const int hand =
        add_link(robot, "hand", forearm, at(0, 0, kArmLength),
                 {{at(0, 0, 0.05), Cylinder{0.035, 0.06}}, box(0.05, 0.15, 0.03, at(0, 0, 0.09))});
    move_last(robot, JointType::revolute, y, wrist);
    for (const double side : {1.0, -1.0}) {
        add_link(robot, side > 0 ? "left-finger" : "right-finger", hand, at(0, 0, 0.1),
                 {box(0.03, 0.014, 0.08, at(0, side * 0.007, 0.04))});
        move_last(robot, JointType::prismatic, side * y, finger);
    }
    robot.groups = {{"arm", {yaw, shoulder, elbow, wrist}, hand}, {"gripper", {finger}, -1}};
    EndEffector tool;
    tool.name = "hand";
    tool.link = hand;
    tool.tool = at(0, 0, kHandLength);
    robot.end_effectors.push_back(tool);
    return robot;
}

Configuration sample_reach(const Vector3& point, double finger) {
    const double radius = std::hypot(point.x(), point.y());
    const double height = point.z() + kHandLength - kShoulderHeight;
    const double distance = std::hypot(radius, height);
    const double elbow = 2 * std::acos(distance / (2 * kArmLength));
    const double shoulder = std::atan2(radius, height) - elbow / 2;
    return {std::atan2(point.y(), point.x()), shoulder, elbow, std::numbers::pi - shoulder - elbow, finger};
}

TrajectoryDocument sample_document() {
    Author author;
    const Vector3 can(0.55, -0.1, 0.4);
    const Vector3 shelf(0.05, 0.62, 0.48);
    const Vector3 up(0, 0, 0.15);
    author.begin("pick", {"can", "table", "#g1", "#q1"});
    author.go(Motion::transit, can + up, 1.2);
    author.go(Motion::approach, can, 0.6);
    author.grip(kClosed);
    author.attach("can");
    author.go(Motion::retreat, can + up, 0.6);
    author.begin("place", {"can", "shelf", "#p1", "#g1"});
    author.go(Motion::transfer, shelf + up / 2, 1.8);
    author.go(Motion::approach, shelf, 0.5);
    author.grip(kOpen);
    author.detach("can");
    author.go(Motion::retreat, shelf + up / 2, 0.5);
    return author.finish();
}

}  // namespace praxis::tamp
