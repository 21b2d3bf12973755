// The seven-joint arm of Franka Emika from its public Denavit-Hartenberg parameters, alone and on a base that
// slides and turns. Kinematics only: links have no shapes.
#pragma once

#include <algorithm>
#include <memory>
#include <numbers>
#include <string>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Group "arm": the hand at link "hand", 0.107 m beyond the flange's joint. With `mobile`, group "all" moves
/// x, y, yaw and the arm; the base may go 5 m from the middle.
inline std::shared_ptr<const Robot> panda_arm(bool mobile = false) {
    Robot robot;
    robot.name = mobile ? "mobile panda" : "panda";
    robot.links.push_back({.name = "root"});
    const auto add = [&](const std::string& name, JointType type, const Pose& origin, const Vector3& axis,
                         double lower, double upper) {
        const int number = static_cast<int>(robot.joints.size());
        Joint joint = {.name = name, .type = type, .parent = number, .child = number + 1, .origin = origin};
        if (type != JointType::fixed) {
            joint.axis = axis;
            joint.variable = static_cast<int>(robot.variables.size());
            robot.variables.push_back({.name = name,
                                       .continuous = type == JointType::continuous,
                                       .lower = lower,
                                       .upper = upper,
                                       .max_velocity = 2,
                                       .max_acceleration = 5});
        }
        robot.joints.push_back(joint);
        robot.links.push_back({.name = name + "_link", .parent_joint = number});
    };
    const Pose here = Pose::Identity();
    if (mobile) {
        add("x", JointType::prismatic, here, Vector3::UnitX(), -5, 5);
        add("y", JointType::prismatic, here, Vector3::UnitY(), -5, 5);
        add("yaw", JointType::continuous, here, Vector3::UnitZ(), -std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity());
    }
    constexpr double kQuarter = std::numbers::pi / 2;
    struct Row {
        Vector3 position;
        double roll;
        double lower;
        double upper;
    };
    const Row rows[] = {{{0, 0, 0.333}, 0, -2.9671, 2.9671},
                        {{0, 0, 0}, -kQuarter, -1.8326, 1.8326},
                        {{0, -0.316, 0}, kQuarter, -2.9671, 2.9671},
                        {{0.0825, 0, 0}, kQuarter, -3.1416, 0.0873},
                        {{-0.0825, 0.384, 0}, -kQuarter, -2.9671, 2.9671},
                        {{0, 0, 0}, kQuarter, -0.0873, 3.8223},
                        {{0.088, 0, 0}, kQuarter, -2.9671, 2.9671}};
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        add("joint" + std::to_string(i + 1), JointType::revolute,
            pose_from_rpy(rows[i].position, {rows[i].roll, 0, 0}), Vector3::UnitZ(), rows[i].lower,
            rows[i].upper);
    }
    add("hand", JointType::fixed, pose_from_rpy({0, 0, 0.107}, {0, 0, -kQuarter / 2}), Vector3::UnitZ(), 0,
        0);
    const int hand = static_cast<int>(robot.links.size()) - 1;
    const int first = mobile ? 3 : 0;
    Group arm = {.name = "arm", .tip = hand};
    for (int i = 0; i < 7; ++i) arm.variables.push_back(first + i);
    robot.groups.push_back(arm);
    if (mobile) {
        Group all = {.name = "all", .tip = hand};
        for (int i = 0; i < 10; ++i) all.variables.push_back(i);
        robot.groups.push_back(all);
    }
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

}  // namespace praxis::tamp
