#include "tamp/robots/planar_base.hpp"

#include <stdexcept>

#include "tamp/robots/robot_options.hpp"

namespace praxis::tamp {

namespace {

/// Links and variables get three in front of them; the first of each joint's or pair's stay in order.
void shift(Robot& robot) {
    constexpr int kShift = 3;
    for (Link& link : robot.links) link.parent_joint += link.parent_joint < 0 ? 0 : kShift;
    for (Joint& joint : robot.joints) {
        joint.parent += kShift;
        joint.child += kShift;
        joint.variable += joint.variable < 0 ? 0 : kShift;
    }
    for (Group& group : robot.groups) {
        for (int& variable : group.variables) variable += kShift;
        group.tip += group.tip < 0 ? 0 : kShift;
    }
    for (EndEffector& effector : robot.end_effectors) {
        effector.link += kShift;
        for (int& link : effector.links) link += kShift;
    }
    for (auto& [first, second] : robot.allowed_collisions) {
        first += kShift;
        second += kShift;
    }
}

}  // namespace

void add_planar_base(Robot& robot, const std::string& name, const std::string& frame) {
    if (robot.find_link(frame) >= 0) {
        throw std::invalid_argument("there is a link '" + frame + "' already, so no frame of that name");
    }
    shift(robot);
    robot.links.front().parent_joint = 2;
    const std::string body = robot.links.front().name;
    robot.links.insert(robot.links.begin(), {{.name = frame},
                                             {.name = body + "/x", .parent_joint = 0},
                                             {.name = body + "/y", .parent_joint = 1}});
    const auto joint = [&](const char* suffix, JointType type, int number, const Vector3& axis) {
        return Joint{.name = name + suffix,
                     .type = type,
                     .parent = number,
                     .child = number + 1,
                     .axis = axis,
                     .variable = number};
    };
    robot.joints.insert(robot.joints.begin(), {joint("/x", JointType::prismatic, 0, Vector3::UnitX()),
                                               joint("/y", JointType::prismatic, 1, Vector3::UnitY()),
                                               joint("/theta", JointType::continuous, 2, Vector3::UnitZ())});
    const auto variable = [&](const char* suffix, bool continuous) {
        return Variable{.name = name + suffix,
                        .continuous = continuous,
                        .max_velocity = kDefaultVelocity,
                        .max_acceleration = kDefaultVelocity / kDefaultAccelerationTime};
    };
    robot.variables.insert(robot.variables.begin(),
                           {variable("/x", false), variable("/y", false), variable("/theta", true)});
}

}  // namespace praxis::tamp
