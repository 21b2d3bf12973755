#include "tamp/motion/inverse_kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace praxis::tamp {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

const Group& group_of(const Robot& robot, int group) {
    if (group < 0 || static_cast<std::size_t>(group) >= robot.groups.size()) {
        throw std::invalid_argument("inverse kinematics: no such group");
    }
    return robot.groups[static_cast<std::size_t>(group)];
}

IkStarts make_starts(const Robot& robot, const Group& group, const KinematicChain& chain,
                     const Configuration& rest) {
    Columns lower = {};
    Columns upper = {};
    Columns middle = {};
    for (std::size_t j = 0; j < group.variables.size(); ++j) {
        const Variable& variable = robot.variables[static_cast<std::size_t>(group.variables[j])];
        middle[j] = rest[static_cast<std::size_t>(group.variables[j])];
        lower[j] = variable.continuous ? -std::numbers::pi : variable.lower;
        upper[j] = variable.continuous ? std::numbers::pi : variable.upper;
    }
    return {chain, lower, upper, middle};
}

void check(const Pose& target, const IkOptions& options) {
    if (!is_finite(target)) throw std::invalid_argument("inverse kinematics: the target is not finite");
    if (!(options.position_tolerance > 0) || !(options.rotation_tolerance > 0)) {
        throw std::invalid_argument("inverse kinematics: tolerances must be positive");
    }
    if (options.attempts < 1 || options.iterations < 1 || !(options.distinct >= 0)) {
        throw std::invalid_argument(
            "inverse kinematics: 'attempts', 'iterations' or 'distinct' is too small");
    }
}

bool out_of_reach(const KinematicChain::Reach& reach, const Pose& target, double tolerance) {
    double squared = 0;
    for (int i = 0; i < 3; ++i) {
        const double difference = target(i, 3) - reach.center[static_cast<std::size_t>(i)];
        squared += difference * difference;
    }
    return std::sqrt(squared) > reach.radius + tolerance + 1e-9;
}

}  // namespace

InverseKinematics::InverseKinematics(std::shared_ptr<const Robot> robot, int group, int link,
                                     const Pose& tool, std::optional<Configuration> rest,
                                     AnalyticKinematics analytic)
    : robot_(std::move(robot)),
      group_(group),
      rest_(rest ? *std::move(rest) : robot_->zero()),
      chain_(*robot_, group, link, tool, rest_),
      starts_(make_starts(*robot_, group_of(*robot_, group), chain_, rest_)),
      analytic_(std::move(analytic)) {
    const Group& moved = group_of(*robot_, group);
    for (std::size_t j = 0; j < chain_.columns(); ++j) {
        const Variable& variable = robot_->variables[static_cast<std::size_t>(moved.variables[j])];
        lower_[j] = variable.lower;
        upper_[j] = variable.upper;
        continuous_[j] = variable.continuous;
    }
}

Pose InverseKinematics::forward(std::span<const double> positions) const {
    if (positions.size() != chain_.columns()) {
        throw std::invalid_argument("inverse kinematics: positions of the wrong size");
    }
    return to_pose(chain_.forward(positions.data()));
}

Columns InverseKinematics::to_columns(const Configuration& positions, const char* name) const {
    if (positions.size() != chain_.columns() ||
        !std::ranges::all_of(positions, [](double q) { return std::isfinite(q); })) {
        throw std::invalid_argument("inverse kinematics: '" + std::string(name) +
                                    "' is not a configuration of the group");
    }
    Columns columns = {};
    for (std::size_t j = 0; j < positions.size(); ++j) {
        columns[j] = std::clamp(positions[j], lower_[j], upper_[j]);
    }
    return columns;
}

void InverseKinematics::normalise(const IkOptions& options, Columns& positions) const {
    for (std::size_t j = 0; j < chain_.columns(); ++j) {
        if (!continuous_[j]) continue;
        const double near = options.start ? (*options.start)[j] : 0;
        positions[j] -= kTurn * std::round((positions[j] - near) / kTurn);
    }
}

template <class Accept>
IkResult InverseKinematics::search(const Pose& target, const IkOptions& options, Accept&& accept) const {
    check(target, options);
    Columns posture = {};
    if (options.posture) posture = to_columns(*options.posture, "posture");
    Columns start = {};
    if (options.start) start = to_columns(*options.start, "start");
    IkResult result;
    if (out_of_reach(chain_.reach(), target, options.position_tolerance)) {
        result.status = IkStatus::out_of_reach;
        return result;
    }
    const IkDescent problem = {.chain = chain_,
                               .target = to_frame(target),
                               .task = options.task,
                               .position_tolerance = options.position_tolerance,
                               .rotation_tolerance = options.rotation_tolerance,
                               .lower = lower_,
                               .upper = upper_,
                               .posture = options.posture ? posture.data() : nullptr,
                               .iterations = options.iterations};
    const auto attempt = [&](Columns& positions) {
        const IkDescentResult found = descend(problem, positions);
        ++result.attempts;
        result.iterations += found.iterations;
        if (!found.converged) return false;
        normalise(options, positions);
        if (!accept(positions)) return false;
        result.status = IkStatus::solved;
        result.position_error = found.position_error;
        result.rotation_error = found.rotation_error;
        result.positions.assign(positions.begin(), positions.begin() + static_cast<int>(chain_.columns()));
        return true;
    };
    if (analytic_) {
        std::vector<Configuration> candidates;
        analytic_(target, candidates);
        for (const Configuration& candidate : candidates) {
            if (!robot_->within_limits(group_of(*robot_, group_), candidate)) continue;
            constexpr double kNearlyRight = 1e-3;
            Columns positions = to_columns(candidate, "candidate");
            const IkDescentResult error = measure(problem, chain_.forward(positions.data()));
            if (error.position_error > kNearlyRight || error.rotation_error > kNearlyRight) continue;
            if (attempt(positions)) return result;
        }
    }
    if (options.start && attempt(start)) return result;
    if (options.posture) {
        Columns positions = posture;
        if (attempt(positions)) return result;
    }
    IkStarts::Order order(starts_, problem, options.seed);
    while (result.attempts < options.attempts) {
        const std::size_t index = order.next();
        if (index == IkStarts::kCount) break;
        Columns positions = starts_[index];
        if (attempt(positions)) return result;
    }
    return result;
}

IkResult InverseKinematics::solve(const Pose& target, const IkOptions& options) const {
    return search(target, options, [](const Columns&) { return true; });
}

std::vector<Configuration> InverseKinematics::solve_all(const Pose& target, std::size_t count,
                                                        const IkOptions& options) const {
    std::vector<Configuration> solutions;
    if (count == 0) return solutions;
    search(target, options, [&](const Columns& positions) {
        const bool known = std::ranges::any_of(solutions, [&](const Configuration& solution) {
            for (std::size_t j = 0; j < solution.size(); ++j) {
                double difference = std::abs(positions[j] - solution[j]);
                if (continuous_[j]) difference = std::abs(std::remainder(difference, kTurn));
                if (difference > options.distinct) return false;
            }
            return true;
        });
        if (known) return false;
        solutions.emplace_back(positions.begin(), positions.begin() + static_cast<int>(chain_.columns()));
        return solutions.size() == count;
    });
    return solutions;
}

}  // namespace praxis::tamp
