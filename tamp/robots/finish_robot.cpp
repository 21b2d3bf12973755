#include "tamp/robots/finish_robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "parser/files.hpp"
#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

Variable& limited_variable(Robot& robot, const std::string& name, const std::string& file) {
    const int variable = robot.find_variable(name);
    if (variable >= 0) return robot.variables[static_cast<std::size_t>(variable)];
    Suggestion suggestion(name);
    for (const Variable& known : robot.variables) suggestion.consider(known.name);
    fail_unplaced(file + ": limits are given for " + quote(name) + ", which is no variable of the robot" +
                  (suggestion.found() ? "; " + suggestion.hint() : ""));
}

double positive(double limit, const std::string& name, const std::string& file) {
    if (limit > 0 && std::isfinite(limit)) return limit;
    fail_unplaced(file + ": the limits of velocity and acceleration of " + quote(name) + " must be above 0");
}

}  // namespace

void cover_links(Robot& robot, const CoverOptions& options) {
    for (Link& link : robot.links) {
        link.balls = cover(link.collision, options);
        link.bound = bounding_ball(link.balls);
    }
}

void apply_limits(Robot& robot, const MotionLimits& limits, const std::string& file) {
    for (const auto& [name, range] : limits.position) {
        Variable& variable = limited_variable(robot, name, file);
        if (!(range.first <= range.second)) {
            fail_unplaced(file + ": the lower limit of " + quote(name) + " is above its upper one");
        }
        variable.lower = range.first;
        variable.upper = range.second;
        variable.continuous = false;
    }
    for (const auto& [name, limit] : limits.velocity) {
        limited_variable(robot, name, file).max_velocity = positive(limit, name, file);
    }
    for (const auto& [name, limit] : limits.acceleration) {
        limited_variable(robot, name, file).max_acceleration = positive(limit, name, file);
    }
}

void allow_neighbours(Robot& robot) {
    auto& pairs = robot.allowed_collisions;
    for (const Joint& joint : robot.joints) pairs.emplace_back(joint.parent, joint.child);
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void require_valid(const Robot& robot, const std::string& file) {
    try {
        check_robot(robot);
    } catch (const std::invalid_argument& error) {
        fail_unplaced(file + ": " + error.what());
    }
}

}  // namespace praxis::tamp
