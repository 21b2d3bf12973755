#include "tamp/manipulation/flying_hand.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace praxis::tamp {

namespace {

constexpr int kFlights = 6;

/// Three slides and three turns, one after the other, from the world to the last link.
void add_flight(Robot& robot) {
    static const char* const names[kFlights] = {"x", "y", "z", "yaw", "pitch", "roll"};
    robot.links.push_back({.name = "flight"});
    Group fly{.name = "fly"};
    for (int i = 0; i < kFlights; ++i) {
        const bool slides = i < 3;
        const std::string name = std::string("flight/") + names[i];
        robot.links.push_back({.name = name, .parent_joint = i});
        robot.joints.push_back({.name = name,
                                .type = slides ? JointType::prismatic : JointType::continuous,
                                .parent = i,
                                .child = i + 1,
                                .axis = Vector3::Unit(slides ? i : 5 - i),
                                .variable = i});
        robot.variables.push_back({.name = name, .continuous = !slides});
        fly.variables.push_back(i);
    }
    fly.tip = kFlights;
    robot.groups.push_back(std::move(fly));
}

class HandMaker {
  public:
    HandMaker(const Robot& whole, const EndEffector& effector, const Configuration& home)
        : whole_(whole), effector_(effector), poses_(whole.links.size()) {
        forward_kinematics(whole, home, poses_);
    }

    FlyingHand run() {
        made_.links.assign(whole_.links.size(), -1);
        made_.frame = kFlights;
        add_flight(robot_);
        robot_.name = whole_.name + "-hand";
        add_variables();
        for (int link = 0; link < static_cast<int>(whole_.links.size()); ++link)
            if (of_hand(link)) add_link(link);
        if (made_.links[static_cast<std::size_t>(effector_.link)] < 0)
            made_.links[static_cast<std::size_t>(effector_.link)] = kFlights;
        for (const auto& [first, second] : whole_.allowed_collisions) {
            const int a = number(first);
            const int b = number(second);
            if (a >= 0 && b >= 0 && a != b) robot_.allowed_collisions.push_back(std::minmax(a, b));
        }
        std::ranges::sort(robot_.allowed_collisions);
        check_robot(robot_);
        made_.robot = std::make_shared<const Robot>(std::move(robot_));
        return std::move(made_);
    }

  private:
    bool of_hand(int link) const { return std::ranges::find(effector_.links, link) != effector_.links.end(); }
    int number(int link) const { return made_.links[static_cast<std::size_t>(link)]; }

    void add_link(int old) {
        const int now = static_cast<int>(robot_.links.size());
        const int moved_by = whole_.links[static_cast<std::size_t>(old)].parent_joint;
        Joint joint{.name = "flight/" + std::to_string(old)};
        const bool known = moved_by >= 0 && number(whole_.joints[static_cast<std::size_t>(moved_by)].parent) >= 0;
        if (known) {
            joint = whole_.joints[static_cast<std::size_t>(moved_by)];
            joint.parent = number(joint.parent);
            joint.variable = variable(joint.variable);
        } else {
            joint.parent = kFlights;
            joint.origin = poses_[static_cast<std::size_t>(effector_.link)].inverse() *
                           poses_[static_cast<std::size_t>(old)];
        }
        joint.child = now;
        made_.links[static_cast<std::size_t>(old)] = now;
        robot_.links.push_back(whole_.links[static_cast<std::size_t>(old)]);
        robot_.links.back().parent_joint = static_cast<int>(robot_.joints.size());
        robot_.joints.push_back(std::move(joint));
    }

    /// Those that move a joint of the hand, in their order.
    void add_variables() {
        for (int old = 0; old < static_cast<int>(whole_.variables.size()); ++old) {
            const bool needed = std::ranges::any_of(whole_.joints, [&](const Joint& joint) {
                return joint.variable == old && of_hand(joint.parent) && of_hand(joint.child);
            });
            if (!needed) continue;
            made_.variables.push_back(old);
            robot_.variables.push_back(whole_.variables[static_cast<std::size_t>(old)]);
        }
    }

    int variable(int old) const {
        const auto known = std::ranges::find(made_.variables, old);
        return known == made_.variables.end() ? -1
                                              : kFlights + static_cast<int>(known - made_.variables.begin());
    }

    const Robot& whole_;
    const EndEffector& effector_;
    std::vector<Pose> poses_;
    Robot robot_;
    FlyingHand made_;
};

}  // namespace

Configuration FlyingHand::at(const Pose& pose) {
    const auto& r = pose.linear();
    const double pitch = std::atan2(-r(2, 0), std::hypot(r(0, 0), r(1, 0)));
    // Where the pitch is a right angle, turns about x and z are the same: all of it goes to z.
    const bool upright = std::hypot(r(0, 0), r(1, 0)) < 1e-9;
    const double yaw = upright ? std::atan2(-r(0, 1), r(1, 1)) : std::atan2(r(1, 0), r(0, 0));
    const double roll = upright ? 0 : std::atan2(r(2, 1), r(2, 2));
    const Vector3& at = pose.translation();
    return {at.x(), at.y(), at.z(), yaw, pitch, roll};
}

Configuration FlyingHand::rest(const Configuration& whole) const {
    Configuration mine(kFlights, 0.0);
    for (const int variable : variables) mine.push_back(whole[static_cast<std::size_t>(variable)]);
    return mine;
}

Attachment FlyingHand::attachment(const Attachment& whole) const {
    Attachment mine{.link = frame, .in_link = whole.in_link};
    for (const int link : whole.touching) {
        const int number = links[static_cast<std::size_t>(link)];
        if (number >= 0) mine.touching.push_back(number);
    }
    return mine;
}

FlyingHand make_flying_hand(const Robot& robot, const EndEffector& effector, const Configuration& home) {
    return HandMaker(robot, effector, home).run();
}

std::shared_ptr<const Robot> make_bare_arm(const Robot& robot, const EndEffector& effector) {
    auto bare = std::make_shared<Robot>(robot);
    for (const int link : effector.links) {
        Link& empty = bare->links[static_cast<std::size_t>(link)];
        empty.collision.clear();
        empty.visual.clear();
        empty.balls.clear();
        empty.bound = {};
    }
    return bare;
}

World part_of(const World& world, std::span<const int> bodies, std::span<const int> links) {
    using Kind = Participant::Kind;
    World part;
    for (const int body : bodies) part = part.with_body(world[body].model, world[body].pose);
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
        const Participant whole{Kind::body, bodies[static_cast<std::size_t>(i)]};
        for (int k = 0; k < i; ++k)
            if (world.allowed(whole, {Kind::body, bodies[static_cast<std::size_t>(k)]}))
                part = part.with_allowed({Kind::body, i}, {Kind::body, k});
        for (int link = 0; link < static_cast<int>(links.size()); ++link) {
            const int number = links[static_cast<std::size_t>(link)];
            if (number >= 0 && world.allowed(whole, {Kind::link, link}))
                part = part.with_allowed({Kind::body, i}, {Kind::link, number});
        }
    }
    return part;
}

}  // namespace praxis::tamp
