// A robot that slides and turns in the plane, and a collision checker that asks a function.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "tamp/collision/checker.hpp"

namespace praxis::tamp {

/// Variables x and y from 0 to 10, and with `turns` a yaw without limits; one group of all.
inline std::shared_ptr<const Robot> point_robot(bool turns = false) {
    Robot robot;
    robot.name = "point";
    robot.links = {
        {.name = "root"}, {.name = "rail", .parent_joint = 0}, {.name = "body", .parent_joint = 1}};
    robot.joints = {{.name = "x",
                     .type = JointType::prismatic,
                     .parent = 0,
                     .child = 1,
                     .axis = Vector3::UnitX(),
                     .variable = 0},
                    {.name = "y",
                     .type = JointType::prismatic,
                     .parent = 1,
                     .child = 2,
                     .axis = Vector3::UnitY(),
                     .variable = 1}};
    robot.variables = {{.name = "x", .lower = 0, .upper = 10}, {.name = "y", .lower = 0, .upper = 10}};
    robot.groups = {{.name = "base", .variables = {0, 1}, .tip = 2}};
    if (turns) {
        robot.links.push_back({.name = "top", .parent_joint = 2});
        robot.joints.push_back(
            {.name = "yaw", .type = JointType::continuous, .parent = 2, .child = 3, .variable = 2});
        robot.variables.push_back({.name = "yaw", .continuous = true});
        robot.groups[0] = {.name = "base", .variables = {0, 1, 2}, .tip = 3};
    }
    check_robot(robot);
    return std::make_shared<const Robot>(std::move(robot));
}

class PointChecker : public CollisionChecker {
  public:
    using Blocked = std::function<bool(std::span<const double>)>;

    PointChecker(std::shared_ptr<const Robot> robot, Blocked blocked) : blocked_(std::move(blocked)) {
        problem_.rest = robot->zero();
        problem_.robot = std::move(robot);
        problem_.world = std::make_shared<const World>();
    }

    const CollisionProblem& problem() const override { return problem_; }
    bool is_free(std::span<const double> positions) override { return !blocked_(positions); }
    bool is_motion_free(std::span<const double> from, std::span<const double> to, double step) override {
        double squared = 0;
        for (std::size_t j = 0; j < from.size(); ++j) squared += (to[j] - from[j]) * (to[j] - from[j]);
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::sqrt(squared) / step)));
        std::vector<double> at(from.size());
        for (int i = 0; i <= pieces; ++i) {
            for (std::size_t j = 0; j < at.size(); ++j) at[j] = from[j] + (to[j] - from[j]) * i / pieces;
            if (blocked_(at)) return false;
        }
        return true;
    }
    void find_contacts(std::span<const double>, std::vector<Contact>&) override {}
    const std::vector<Contact>& fixed_contacts() const override { return none_; }

  private:
    CollisionProblem problem_;
    Blocked blocked_;
    std::vector<Contact> none_;
};

}  // namespace praxis::tamp
