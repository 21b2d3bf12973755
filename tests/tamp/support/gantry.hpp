// A hand that hangs from three rails, and motions for it made by hand: up, across, down, grip, up.
//
// There is nothing to collide with; it has what skills need: kinematics, limits, timing, a gripper.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tamp/motion/time_parametrisation.hpp"
#include "tamp/report/describe.hpp"
#include "tamp/skills/refined_skill.hpp"

namespace praxis::tamp::test {

inline constexpr double kGantryHeight = 0.3;  ///< of the hand when it goes across, metres
inline constexpr double kOpen = 0.06, kClosed = 0.03;

/// Variables x, y, z and finger; the hand is where x, y and z say.
inline Robot gantry() {
    Robot robot;
    robot.name = "gantry";
    robot.links.push_back({.name = "frame"});
    const auto add = [&](const char* name, int parent, const Vector3& axis, double limit) {
        const int link = static_cast<int>(robot.links.size());
        robot.joints.push_back({.name = name,
                                .type = JointType::prismatic,
                                .parent = parent,
                                .child = link,
                                .axis = axis,
                                .variable = link - 1});
        robot.links.push_back({.name = std::string(name) + "-link", .parent_joint = link - 1});
        robot.variables.push_back(
            {.name = name, .lower = -limit, .upper = limit, .max_velocity = 0.5, .max_acceleration = 2});
    };
    add("x", 0, Vector3::UnitX(), 2);
    add("y", 1, Vector3::UnitY(), 2);
    add("z", 2, Vector3::UnitZ(), 1);
    add("finger", 3, Vector3::UnitY(), kOpen);
    robot.groups = {{"arm", {0, 1, 2}, 3}, {"gripper", {3}, -1}};
    check_robot(robot);
    return robot;
}

inline Configuration gantry_home() {
    return {0, 0, kGantryHeight, kOpen};
}

inline Pose at(double x, double y, double z = 0) {
    return Pose(Eigen::Translation3d(x, y, z));
}

/// Cups, each of which stands somewhere.
inline World cups(const std::vector<std::pair<std::string, Pose>>& all) {
    World world;
    for (const auto& [name, pose] : all) {
        BodyModel cup{.name = name, .shapes = {{Pose::Identity(), Cylinder{0.02, 0.1}}}, .movable = true};
        world = world.with_body(std::make_shared<const BodyModel>(std::move(cup)), pose);
    }
    return world;
}

/// Writes a document action by action; each action begins and ends at the home configuration.
class GantryPlan {
  public:
    /// From the home configuration; `held`: the cup that is in the hand, in its middle.
    explicit GantryPlan(const World& world, const std::string& held = "")
        : robot_(gantry()), world_(world), now_(gantry_home()) {
        if (!held.empty()) {
            world_ = world_.with_attached(world_.find(held), {.link = kHand});
            now_[3] = kClosed;
        }
        document_ = begin_document(robot_, world_, now_);
    }

    void pick(const std::string& cup, const Pose& pose, std::vector<std::string> arguments) {
        begin("pick", std::move(arguments));
        reach(Motion::transit, pose.translation());
        grip(kClosed);
        const Attachment attachment{.link = kHand};
        world_ = world_.with_attached(world_.find(cup), attachment);
        document_.segments.back().attach = describe_hold(robot_, world_, world_.find(cup), attachment);
        leave(Motion::transfer);
    }
    void place(const std::string& cup, const Pose& pose, std::vector<std::string> arguments) {
        begin("place", std::move(arguments));
        reach(Motion::transfer, pose.translation());
        grip(kOpen);
        world_ = world_.with_pose(world_.find(cup), pose);
        document_.segments.back().detach = describe_stand(world_, world_.find(cup), pose);
        leave(Motion::transit);
    }
    /// The hand goes over a place, and back.
    void look(const Pose& pose, std::vector<std::string> arguments) {
        begin("look", std::move(arguments));
        move(0, Motion::transit, {arm(), {pose.translation().x(), pose.translation().y(), kGantryHeight}});
        leave(Motion::transit);
    }
    /// Nothing moves.
    void begin(const std::string& name, std::vector<std::string> arguments) {
        document_.plan.push_back({name, std::move(arguments), time_, time_});
    }
    void value(const std::string& name, const Pose& pose) {
        const TrajectoryDocument::PoseNumbers numbers = to_numbers(pose);
        document_.values[name] = {"pose", {numbers.begin(), numbers.end()}};
    }
    TrajectoryDocument& document() { return document_; }
    std::vector<RefinedSkill> skills() const { return refined_skills(document_); }

  private:
    using Motion = TrajectoryDocument::Motion;
    static constexpr int kHand = 3;

    void reach(Motion kind, const Vector3& point) {
        move(0, kind, {arm(), {point.x(), point.y(), kGantryHeight}, {point.x(), point.y(), point.z()}});
    }
    void leave(Motion kind) {
        move(0, kind, {arm(), {now_[0], now_[1], kGantryHeight}, {0, 0, kGantryHeight}});
    }
    void grip(double finger) { move(1, Motion::gripper, {{now_[3]}, {finger}}); }
    Configuration arm() const { return {now_[0], now_[1], now_[2]}; }

    void move(std::size_t number, Motion kind, const Path& path) {
        const Group& group = robot_.groups[number];
        const Trajectory trajectory = time_parametrise(path, motion_limits(robot_, group));
        const int action = static_cast<int>(document_.plan.size()) - 1;
        document_.segments.push_back(describe_motion(group, trajectory, action, kind, time_));
        time_ = document_.plan.back().end = document_.segments.back().end;
        robot_.insert(group, path.back(), now_);
    }

    Robot robot_;
    World world_;
    Configuration now_;
    double time_ = 0;
    TrajectoryDocument document_;
};

}  // namespace praxis::tamp::test
