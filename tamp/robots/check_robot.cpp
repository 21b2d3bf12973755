#include <cmath>
#include <stdexcept>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

namespace {

constexpr std::size_t kMaximumLinks = 64;
constexpr std::size_t kMaximumVariables = 32;
constexpr std::size_t kMaximumGroup = 16;

[[noreturn]] void refuse(const Robot& robot, const std::string& why) {
    throw std::invalid_argument("robot '" + robot.name + "': " + why);
}

bool is_index(int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
}

void check_joints(const Robot& robot) {
    if (robot.joints.size() + 1 != robot.links.size())
        refuse(robot, "every link but the root needs one joint");
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
        const Joint& joint = robot.joints[i];
        const std::string name = "joint '" + joint.name + "'";
        if (!is_index(joint.parent, robot.links.size()) || !is_index(joint.child, robot.links.size()) ||
            joint.parent >= joint.child ||
            robot.links[static_cast<std::size_t>(joint.child)].parent_joint != static_cast<int>(i)) {
            refuse(robot, name + " joins links that do not come parents first");
        }
        if (!is_finite(joint.origin)) refuse(robot, name + " has an origin that is not finite");
        if (!(std::abs(joint.axis.norm() - 1) < 1e-6))
            refuse(robot, name + " has an axis that is no unit vector");
        if ((joint.type == JointType::fixed) != (joint.variable < 0)) {
            refuse(robot, name + " must have a variable if and only if it moves");
        }
        if (joint.variable >= 0 && !is_index(joint.variable, robot.variables.size())) {
            refuse(robot, name + " names a variable that is not there");
        }
        if (!std::isfinite(joint.multiplier) || !std::isfinite(joint.offset)) {
            refuse(robot, name + " mimics by numbers that are not finite");
        }
    }
}

void check_variables(const Robot& robot) {
    for (const Variable& variable : robot.variables) {
        if (!(variable.lower <= variable.upper)) {
            refuse(robot, "variable '" + variable.name + "' has a lower limit above its upper one");
        }
        const auto positive = [](double number) { return number > 0 && std::isfinite(number); };
        if (!positive(variable.max_velocity) || !positive(variable.max_acceleration)) {
            refuse(robot,
                   "variable '" + variable.name + "' needs limits of velocity and acceleration above 0");
        }
    }
}

void check_groups(const Robot& robot) {
    for (const Group& group : robot.groups) {
        const std::string name = "group '" + group.name + "'";
        if (group.variables.empty() || group.variables.size() > kMaximumGroup) {
            refuse(robot, name + " must have 1 to 16 variables");
        }
        for (std::size_t i = 0; i < group.variables.size(); ++i) {
            if (!is_index(group.variables[i], robot.variables.size()) ||
                (i > 0 && group.variables[i] <= group.variables[i - 1])) {
                refuse(robot, name + " must list variables of the robot in increasing order");
            }
        }
        if (group.tip != -1 && !is_index(group.tip, robot.links.size()))
            refuse(robot, name + " has no such tip");
    }
    for (const NamedState& state : robot.states) {
        const int group = robot.find_group(state.group);
        if (group < 0)
            refuse(robot, "state '" + state.name + "' is of an unknown group '" + state.group + "'");
        if (state.positions.size() != robot.groups[static_cast<std::size_t>(group)].variables.size()) {
            refuse(robot, "state '" + state.name + "' does not have one position a variable of its group");
        }
    }
    for (const EndEffector& effector : robot.end_effectors) {
        if (!is_index(effector.link, robot.links.size()) || robot.find_group(effector.arm) < 0 ||
            (!effector.gripper.empty() && robot.find_group(effector.gripper) < 0)) {
            refuse(robot, "end effector '" + effector.name + "' names a link or group that is not there");
        }
    }
}

}  // namespace

void check_robot(const Robot& robot) {
    if (robot.links.empty() || robot.links.size() > kMaximumLinks) refuse(robot, "must have 1 to 64 links");
    if (robot.variables.size() > kMaximumVariables) refuse(robot, "may have at most 32 variables");
    if (robot.links[0].parent_joint != -1) refuse(robot, "link 0 must be the root");
    if (!is_finite(robot.base)) refuse(robot, "has a base pose that is not finite");
    check_joints(robot);
    check_variables(robot);
    check_groups(robot);
    for (const auto& [first, second] : robot.allowed_collisions) {
        if (first >= second || !is_index(first, robot.links.size()) ||
            !is_index(second, robot.links.size())) {
            refuse(robot, "allowed collisions must be pairs of links, the smaller number first");
        }
    }
}

}  // namespace praxis::tamp
