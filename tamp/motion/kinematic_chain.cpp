#include "tamp/motion/kinematic_chain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

namespace {

using Vector = std::array<double, 3>;

Vector combine(const Frame& frame, const Vector& v) {
    Vector result;
    for (std::size_t i = 0; i < 3; ++i) {
        result[i] = frame.x[i] * v[0] + frame.y[i] * v[1] + frame.z[i] * v[2];
    }
    return result;
}

Frame compose(const Frame& outer, const Frame& inner) {
    Frame result = {.x = combine(outer, inner.x),
                    .y = combine(outer, inner.y),
                    .z = combine(outer, inner.z),
                    .origin = combine(outer, inner.origin)};
    for (std::size_t i = 0; i < 3; ++i) result.origin[i] += outer.origin[i];
    return result;
}

void turn(Frame& frame, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    for (std::size_t i = 0; i < 3; ++i) {
        const double x = frame.x[i];
        frame.x[i] = c * x + s * frame.y[i];
        frame.y[i] = c * frame.y[i] - s * x;
    }
}

void slide(Frame& frame, double distance) {
    for (std::size_t i = 0; i < 3; ++i) frame.origin[i] += distance * frame.z[i];
}

double length(const Vector& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace

Frame to_frame(const Pose& pose) {
    Frame frame;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        frame.x[at] = pose(i, 0);
        frame.y[at] = pose(i, 1);
        frame.z[at] = pose(i, 2);
        frame.origin[at] = pose(i, 3);
    }
    return frame;
}

Pose to_pose(const Frame& frame) {
    Pose pose = Pose::Identity();
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        pose(i, 0) = frame.x[at];
        pose(i, 1) = frame.y[at];
        pose(i, 2) = frame.z[at];
        pose(i, 3) = frame.origin[at];
    }
    return pose;
}

KinematicChain::KinematicChain(const Robot& robot, int group, int link, const Pose& tool,
                               std::span<const double> rest) {
    if (group < 0 || static_cast<std::size_t>(group) >= robot.groups.size()) {
        throw std::invalid_argument("kinematic chain: no such group");
    }
    if (link < 0 || static_cast<std::size_t>(link) >= robot.links.size()) {
        throw std::invalid_argument("kinematic chain: no such link");
    }
    if (rest.size() != robot.dimension() ||
        !std::ranges::all_of(rest, [](double q) { return std::isfinite(q); })) {
        throw std::invalid_argument("kinematic chain: 'rest' is not a configuration of the robot");
    }
    if (!is_finite(tool)) throw std::invalid_argument("kinematic chain: the tool's pose is not finite");
    const std::vector<int>& variables = robot.groups[static_cast<std::size_t>(group)].variables;
    columns_ = variables.size();
    if (columns_ > kMaxColumns) throw std::invalid_argument("kinematic chain: too many variables");

    std::vector<const Joint*> joints;
    for (int at = link; at != 0; at = joints.back()->parent) {
        const int parent_joint = robot.links[static_cast<std::size_t>(at)].parent_joint;
        joints.push_back(&robot.joints[static_cast<std::size_t>(parent_joint)]);
    }
    Pose pending = robot.base;
    double radius = 0;
    for (auto it = joints.rbegin(); it != joints.rend(); ++it) {
        const Joint& joint = **it;
        pending = pending * joint.origin;
        if (joint.variable < 0) continue;
        const bool slides = joint.type == JointType::prismatic;
        const auto variable = static_cast<std::size_t>(joint.variable);
        const auto found = std::ranges::find(variables, joint.variable);
        if (found == variables.end()) {
            const double position = joint.multiplier * rest[variable] + joint.offset;
            if (slides) {
                pending.translate(position * joint.axis);
            } else {
                pending.rotate(Eigen::AngleAxisd(position, joint.axis));
            }
            continue;
        }
        const Eigen::Quaterniond upright =
            Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), joint.axis).normalized();
        pending.rotate(upright);
        links_.push_back({.fixed = to_frame(pending),
                          .slides = slides,
                          .column = static_cast<std::size_t>(found - variables.begin()),
                          .multiplier = joint.multiplier,
                          .offset = joint.offset});
        if (links_.size() > 1) radius += pending.translation().norm();
        if (slides) {
            const Variable& limits = robot.variables[variable];
            radius += std::max(std::abs(joint.multiplier * limits.lower + joint.offset),
                               std::abs(joint.multiplier * limits.upper + joint.offset));
        }
        pending = Pose(upright.conjugate());
    }
    if (links_.empty()) throw std::invalid_argument("kinematic chain: the group does not move the link");
    pending = pending * tool;
    tail_ = to_frame(pending);
    reach_ = {.center = links_.front().fixed.origin, .radius = radius + length(tail_.origin)};
}

template <bool kWithJacobian>
Frame KinematicChain::run(const double* positions, Jacobian* jacobian) const {
    std::array<Vector, 64> axes;
    std::array<Vector, 64> origins;
    Frame frame;
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Link& link = links_[i];
        frame = i == 0 ? link.fixed : compose(frame, link.fixed);
        if constexpr (kWithJacobian) {
            axes[i] = frame.z;
            origins[i] = frame.origin;
        }
        const double position = link.multiplier * positions[link.column] + link.offset;
        if (link.slides) {
            slide(frame, position);
        } else {
            turn(frame, position);
        }
    }
    frame = compose(frame, tail_);
    if constexpr (kWithJacobian) {
        for (std::size_t j = 0; j < columns_; ++j) jacobian->linear[j] = jacobian->angular[j] = {0, 0, 0};
        for (std::size_t i = 0; i < links_.size(); ++i) {
            const Link& link = links_[i];
            Vector& linear = jacobian->linear[link.column];
            Vector& angular = jacobian->angular[link.column];
            const Vector& axis = axes[i];
            const double rate = link.multiplier;
            if (link.slides) {
                for (std::size_t k = 0; k < 3; ++k) linear[k] += rate * axis[k];
                continue;
            }
            const Vector arm = {frame.origin[0] - origins[i][0], frame.origin[1] - origins[i][1],
                                frame.origin[2] - origins[i][2]};
            linear[0] += rate * (axis[1] * arm[2] - axis[2] * arm[1]);
            linear[1] += rate * (axis[2] * arm[0] - axis[0] * arm[2]);
            linear[2] += rate * (axis[0] * arm[1] - axis[1] * arm[0]);
            for (std::size_t k = 0; k < 3; ++k) angular[k] += rate * axis[k];
        }
    }
    return frame;
}

Frame KinematicChain::forward(const double* positions) const {
    return run<false>(positions, nullptr);
}

Frame KinematicChain::forward(const double* positions, Jacobian& jacobian) const {
    return run<true>(positions, &jacobian);
}

}  // namespace praxis::tamp
