#include "tamp/robots/robot.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::tamp {

namespace {

template <class T>
int find_named(const std::vector<T>& items, std::string_view name) {
    const auto found = std::ranges::find(items, name, &T::name);
    return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

Pose joint_motion(const Joint& joint, std::span<const double> configuration) {
    Pose motion = Pose::Identity();
    if (joint.variable < 0) return motion;
    const double position =
        joint.multiplier * configuration[static_cast<std::size_t>(joint.variable)] + joint.offset;
    if (joint.type == JointType::prismatic) {
        motion.translation() = position * joint.axis;
    } else {
        motion.linear() = Eigen::AngleAxisd(position, joint.axis).toRotationMatrix();
    }
    return motion;
}

}  // namespace

int Robot::find_link(std::string_view wanted) const {
    return find_named(links, wanted);
}

int Robot::find_variable(std::string_view wanted) const {
    return find_named(variables, wanted);
}

int Robot::find_group(std::string_view wanted) const {
    return find_named(groups, wanted);
}

int Robot::find_end_effector(std::string_view wanted) const {
    return find_named(end_effectors, wanted);
}

bool Robot::may_collide(int first_link, int second_link) const {
    if (first_link == second_link) return false;
    const std::pair<int, int> pair = std::minmax(first_link, second_link);
    return !std::ranges::binary_search(allowed_collisions, pair);
}

Configuration Robot::zero() const {
    Configuration configuration;
    configuration.reserve(variables.size());
    for (const Variable& variable : variables) {
        configuration.push_back(std::clamp(0.0, variable.lower, variable.upper));
    }
    return configuration;
}

Configuration Robot::extract(const Group& group, std::span<const double> configuration) const {
    Configuration positions;
    positions.reserve(group.variables.size());
    for (int variable : group.variables) {
        positions.push_back(configuration[static_cast<std::size_t>(variable)]);
    }
    return positions;
}

void Robot::insert(const Group& group, std::span<const double> positions,
                   std::span<double> configuration) const {
    for (std::size_t i = 0; i < group.variables.size(); ++i) {
        configuration[static_cast<std::size_t>(group.variables[i])] = positions[i];
    }
}

bool Robot::within_limits(const Group& group, std::span<const double> positions) const {
    constexpr double kTolerance = 1e-9;
    if (positions.size() != group.variables.size()) return false;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const Variable& variable = variables[static_cast<std::size_t>(group.variables[i])];
        if (!std::isfinite(positions[i]) || positions[i] < variable.lower - kTolerance ||
            positions[i] > variable.upper + kTolerance) {
            return false;
        }
    }
    return true;
}

void forward_kinematics(const Robot& robot, std::span<const double> configuration, std::span<Pose> poses) {
    poses[0] = robot.base;
    for (const Joint& joint : robot.joints) {
        poses[static_cast<std::size_t>(joint.child)] =
            poses[static_cast<std::size_t>(joint.parent)] * joint.origin * joint_motion(joint, configuration);
    }
}

Pose link_pose(const Robot& robot, std::span<const double> configuration, int link) {
    Pose pose = Pose::Identity();
    while (link != 0) {
        const Joint& joint =
            robot.joints[static_cast<std::size_t>(robot.links[static_cast<std::size_t>(link)].parent_joint)];
        pose = joint.origin * joint_motion(joint, configuration) * pose;
        link = joint.parent;
    }
    return robot.base * pose;
}

}  // namespace praxis::tamp
