#include "tamp/manipulation/manipulator_model.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/collision/fast_checker.hpp"
#include "tamp/motion/straight_line.hpp"

namespace praxis::tamp {

namespace {

/// How exactly the hand is brought to a body, metres and radians: far below what the validator lets pass.
constexpr double kHandTolerance = 1e-7;

int require_group(const Robot& robot, const std::string& name) {
    const int group = robot.find_group(name);
    if (group < 0) throw std::invalid_argument("robot '" + robot.name + "' has no group '" + name + "'");
    return group;
}

const EndEffector& require_effector(const Robot& robot, const std::string& name) {
    if (robot.end_effectors.empty()) {
        throw std::invalid_argument("robot '" + robot.name + "' has no end effector");
    }
    if (name.empty()) return robot.end_effectors.front();
    const int effector = robot.find_end_effector(name);
    if (effector < 0) {
        throw std::invalid_argument("robot '" + robot.name + "' has no end effector '" + name + "'");
    }
    return robot.end_effectors[static_cast<std::size_t>(effector)];
}

/// The parent of the first joint that the group moves.
int find_carrier(const Robot& robot, const Group& arm) {
    for (const Joint& joint : robot.joints) {
        if (std::ranges::find(arm.variables, joint.variable) != arm.variables.end()) return joint.parent;
    }
    return 0;
}

/// The planner works on floats: its ends are set to what was asked for. False: they are not the same, but by
/// whole turns of an angle without limits.
bool snap(Configuration& positions, const Configuration& exact) {
    constexpr double kRounding = 1e-4;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (std::abs(positions[i] - exact[i]) > kRounding) return false;
    }
    positions = exact;
    return true;
}

}  // namespace

ManipulatorModel::ManipulatorModel(std::shared_ptr<const Robot> robot_, Configuration home_,
                                   const std::string& effector_name, const std::string& base_group,
                                   const ManipulatorOptions& options_)
    : robot(std::move(robot_)),
      effector(require_effector(*robot, effector_name)),
      options(options_),
      arm(require_group(*robot, effector.arm)),
      home(std::move(home_)),
      carrier_(find_carrier(*robot, group(arm))),
      carrier_at_rest_(link_pose(*robot, robot->zero(), carrier_)),
      ik_(robot, arm, effector.link, effector.tool),
      wrist_(find_wrist()) {
    if (home.size() != robot->dimension()) {
        throw std::invalid_argument("the home configuration does not fit robot '" + robot->name + "'");
    }
    if (effector.open && effector.closed) {
        gripper = require_group(*robot, effector.gripper);
        robot->insert(group(gripper), *effector.open, home);
    }
    if (base_group.empty()) return;
    base = require_group(*robot, base_group);
    if (group(base).variables.size() != 3) {
        throw std::invalid_argument("the group '" + base_group + "' of the base must have x, y and yaw");
    }
}

std::unique_ptr<CollisionChecker> ManipulatorModel::checker(WorldPointer world, int of_group,
                                                            const Configuration& rest) const {
    return make_fast_checker({robot, std::move(world), of_group, rest}, cache_);
}

Configuration ManipulatorModel::fingers(double opening) const {
    const Configuration& closed = *effector.closed;
    const Configuration& open = *effector.open;
    const double share = std::clamp(opening / effector.max_opening, 0.0, 1.0);
    Configuration positions(closed.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        positions[i] = closed[i] + share * (open[i] - closed[i]);
    return positions;
}

double ManipulatorModel::grip(const Grasp& grasp) {
    constexpr double kGap = 0.001;
    return grasp.opening + kGap;
}

Attachment ManipulatorModel::hold(const Grasp& grasp) const {
    return {.link = effector.link, .in_link = effector.tool * grasp.body_in_tool, .touching = effector.links};
}

Pose ManipulatorModel::tool(const Configuration& configuration) const {
    return link_pose(*robot, configuration, effector.link) * effector.tool;
}

MotionResult ManipulatorModel::travel(CollisionChecker& checker, const Configuration& start,
                                      const Configuration& goal, std::uint64_t variation,
                                      const Budget& budget, int max_iterations) const {
    constexpr std::uint64_t kTries = 3;
    MotionResult found;
    for (std::uint64_t i = 0; i < kTries; ++i) {
        found = plan_motion(checker, start, std::span(&goal, 1),
                            {.seed = options.seed + variation + (i << 32),
                             .certified = options.certified,
                             .max_iterations = max_iterations,
                             .budget = budget.within(options.plan_time)});
        if (found.status != MotionStatus::solved) return found;
        if (snap(found.path.front(), start) && snap(found.path.back(), goal)) return found;
    }
    found.status = MotionStatus::not_found;
    return found;
}

Pose ManipulatorModel::to_solver(const Configuration& configuration) const {
    return carrier_at_rest_ * link_pose(*robot, configuration, carrier_).inverse();
}

/// Behind the last joint of the arm nothing bends; so the target says where that joint is, and the arm before
/// it must be long enough. Most targets out of reach are seen so, without a search.
std::optional<ManipulatorModel::Wrist> ManipulatorModel::find_wrist() const {
    const std::vector<int>& variables = group(arm).variables;
    if (variables.size() < 3) return std::nullopt;
    int link = effector.link;
    while (robot->links[static_cast<std::size_t>(link)].parent_joint >= 0) {
        const Joint& joint =
            robot
                ->joints[static_cast<std::size_t>(robot->links[static_cast<std::size_t>(link)].parent_joint)];
        if (joint.variable >= 0) {
            const bool turns = joint.type == JointType::revolute || joint.type == JointType::continuous;
            if (!turns || joint.variable != variables.back()) return std::nullopt;
            const Configuration rest = robot->zero();
            Wrist wrist;
            wrist.in_tool = tool(rest).inverse() * link_pose(*robot, rest, link);
            wrist.reach = KinematicChain(*robot, arm, joint.parent, joint.origin, rest).reach();
            return wrist;
        }
        link = joint.parent;
    }
    return std::nullopt;
}

bool ManipulatorModel::is_out_of_reach(const Pose& target) const {
    if (!wrist_) return false;
    constexpr double kTolerance = 1e-4;
    const Vector3 wrist = (target * wrist_->in_tool).translation();
    const Vector3 center(wrist_->reach.center[0], wrist_->reach.center[1], wrist_->reach.center[2]);
    return (wrist - center).norm() > wrist_->reach.radius + kTolerance;
}

std::optional<Configuration> ManipulatorModel::reach(const Configuration& configuration, const Pose& target,
                                                     std::uint64_t number) const {
    IkOptions asked;
    asked.position_tolerance = asked.rotation_tolerance = kHandTolerance;
    const Pose to = to_solver(configuration) * target;
    if (is_out_of_reach(to)) return std::nullopt;
    if (number == 0) asked.start = robot->extract(group(arm), configuration);
    asked.seed = options.seed + number;
    IkResult found = ik_.solve(to, asked);
    if (!found) return std::nullopt;
    return std::move(found.positions);
}

std::optional<Path> ManipulatorModel::straight(const Configuration& configuration, const Configuration& from,
                                               std::span<const Vector3> legs) const {
    const Pose to = to_solver(configuration);
    Path path = {from};
    for (const Vector3& leg : legs) {
        Pose target = ik_.forward(path.back());
        target.translation() += to.linear() * leg;
        const StraightLine line = straight_line(ik_, path.back(), target);
        if (line.end != LineEnd::arrived) return std::nullopt;
        path.insert(path.end(), line.path.begin() + 1, line.path.end());
    }
    return path;
}

}  // namespace praxis::tamp
