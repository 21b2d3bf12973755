#include "tamp/manipulation/site.hpp"

#include <algorithm>
#include <cmath>

#include "tamp/geometry/extent.hpp"
#include "tamp/sampling/base_poses.hpp"

namespace praxis::tamp {

namespace {

using Reason = TrajectoryDocument::Reason;

void include(AxisBox& box, bool& empty, const AxisBox& other) {
    if (empty)
        box = other;
    else
        box.include(other);
    empty = false;
}

/// Around the links' balls at a configuration.
AxisBox box_of(const Robot& robot, const Configuration& configuration) {
    std::vector<Pose> poses(robot.links.size());
    forward_kinematics(robot, configuration, poses);
    AxisBox box;
    bool empty = true;
    for (std::size_t link = 0; link < robot.links.size(); ++link) {
        const Ball& bound = robot.links[link].bound;
        if (bound.radius > 0) include(box, empty, box_around(poses[link] * bound.center, bound.radius));
    }
    return box;
}

/// The arm follows the hand's straight lines this well, in metres.
constexpr double kDeviation = 1.5e-3;

AxisBox shifted(const AxisBox& box, const Vector3& by) {
    return {box.lower + by, box.upper + by};
}

ActionFailure unreachable(const std::string& message) {
    return {.reason = Reason::kinematics, .message = message};
}

}  // namespace

bool is_path_free(CollisionChecker& checker, const Path& path, bool certified) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        if (!(certified ? checker.is_motion_certified(path[i], path[i + 1])
                        : checker.is_motion_free(path[i], path[i + 1]))) {
            return false;
        }
    }
    return true;
}

Site::Site(SkillSpace& space, int body, const Pose& pose, const Grasp& grasp)
    : space_(space),
      body_(body),
      pose_(pose),
      standing_(space.standing(body, pose)),
      held_(space.held(body, grasp)),
      target_(pose * grasp.body_in_tool.inverse()),
      back_(-space.model().options.approach * target_.linear().col(2)) {
    // Straight up; under a roof a little up, then back along the hand; where even that is too much, only back.
    const ManipulatorOptions& options = space.model().options;
    legs_ = {{{{0, 0, options.lift}}, {{0, 0, options.low_lift}, back_}, {back_}}};
    hand_back_ = hand_path({&back_, 1});
    for (std::size_t i = 0; i < kLifts; ++i) hand_lifts_[i] = hand_path(legs_[i]);
    check_hand();
}

Path Site::hand_path(std::span<const Vector3> legs) const {
    Pose hand = target_ * space_.model().effector.tool.inverse();
    Path path = {FlyingHand::at(hand)};
    for (const Vector3& leg : legs) {
        Configuration next = path.back();
        for (std::size_t k = 0; k < 3; ++k) next[k] += leg[static_cast<Eigen::Index>(k)];
        path.push_back(std::move(next));
    }
    return path;
}

void Site::check_hand() {
    const auto open = space_.checker({.probe = Probe::open_hand});
    const Configuration& at = hand_back_.front();
    Configuration rest = open->problem().rest;
    std::ranges::copy(at, rest.begin());
    AxisBox box = box_of(*open->problem().robot, rest);
    box.include(extent(space_.body(body_).shapes, pose_));
    box = {box.lower.array() - kDeviation, box.upper.array() + kDeviation};
    box_ = box;
    for (const std::vector<Vector3>& legs : legs_) {
        Vector3 by = Vector3::Zero();
        for (const Vector3& leg : legs) box_.include(shifted(box, by += leg));
    }
    if (!is_path_free(*open, hand_back_, space_.model().options.certified)) {
        failure_ = space_.explain({.probe = Probe::open_hand}, hand_back_, "the hand");
    } else if (!space_.fits(held_)) {
        failure_ = {.reason = Reason::collision, .message = "the body does not fit between the fingers"};
    } else if (!space_.can_carry(held_)) {
        failure_ = {.reason = Reason::collision, .message = "held so, the body is in collision at home"};
    } else if (!can_lift(0) && !can_lift(1) && !can_lift(2)) {
        failure_ = space_.explain({.probe = Probe::holding_hand, .held = held_}, hand_lifts_.front(),
                                  "the hand as it lifts");
    }
}

bool Site::can_lift(std::size_t lift) {
    std::optional<bool>& known = open_[lift];
    if (!known) {
        known = is_path_free(*space_.checker({.probe = Probe::holding_hand, .held = held_}), hand_lifts_[lift],
                             space_.model().options.certified);
    }
    return *known;
}

bool Site::is_near(int body, const Pose& pose) const {
    return extent(space_.body(body).shapes, pose).overlaps(box_);
}

const ActionFailure* Site::decide(Obstacle& obstacle, std::size_t part, const ProbeOf& probe, const Path& path,
                                  const std::string& phase) {
    std::optional<bool>& stops = obstacle.stops[part];
    if (!stops) {
        stops = !is_path_free(*space_.checker(probe), path, space_.model().options.certified);
        if (*stops && obstacle.why.message.empty()) obstacle.why = space_.explain(probe, path, phase);
    }
    return *stops ? &obstacle.why : nullptr;
}

const ActionFailure* Site::stopped(std::size_t part, int body, const Pose& pose, SkillSpace::Id standing) {
    const auto [at, is_new] = obstacles_.try_emplace(standing);
    Obstacle& found = at->second;
    if (is_new) found.far = !is_near(body, pose);
    if (found.far) return nullptr;
    const ProbeOf holding{.probe = Probe::holding_hand_at, .standing = standing, .held = held_};
    if (part > 0) return decide(found, part, holding, hand_lifts_[part - 1], "the hand as it lifts");
    if (found.stops[0]) return *found.stops[0] ? &found.why : nullptr;
    if (!space_.checker(holding)->is_free(hand_back_.front())) {
        found.stops[0] = true;
        found.why = space_.explain(holding, {hand_back_.front()}, "what the hand holds");
        return &found.why;
    }
    return decide(found, 0, {.probe = Probe::open_hand_at, .standing = standing}, hand_back_, "the hand");
}

std::vector<Stance>& Site::stances() {
    if (!stances_.empty()) return stances_;
    const ManipulatorModel& model = space_.model();
    if (model.base < 0) {
        stances_.emplace_back();
        return stances_;
    }
    const BasePoseOptions ring{model.options.base_nearest, model.options.base_furthest,
                               model.options.base_poses};
    const Configuration now = model.robot->extract(model.group(model.base), model.home);
    for (Configuration& positions : make_base_poses(pose_.translation(), now, ring)) {
        if (!model.robot->within_limits(model.group(model.base), positions)) continue;
        Stance& stance = stances_.emplace_back();
        stance.base = space_.base(positions);
        stance.positions = std::move(positions);
    }
    return stances_;
}

Way& Site::way(Stance& stance, std::uint64_t number) {
    const auto [at, is_new] = stance.ways.try_emplace(number);
    if (is_new) at->second = make_way(stance, number);
    return at->second;
}

Way Site::make_way(const Stance& stance, std::uint64_t number) {
    const ManipulatorModel& model = space_.model();
    const bool certified = model.options.certified;
    Way way;
    const Configuration home = space_.home(stance.base);
    const std::optional<Configuration> arm = model.reach(home, target_, number);
    if (!arm) {
        way.failure = unreachable("the arm does not reach it");
        return way;
    }
    way.arm = *arm;
    const ProbeOf open{.probe = Probe::open_arm, .standing = standing_, .base = stance.base};
    const auto empty = space_.checker(open);
    if (!empty->is_free(*arm)) {
        way.failure = space_.explain(open, {*arm}, "the arm at its target");
        return way;
    }
    std::optional<Path> back = model.straight(home, *arm, {&back_, 1});
    if (!back) {
        way.failure = unreachable("the arm cannot make the way back");
        return way;
    }
    if (!is_path_free(*empty, *back, certified)) {
        way.failure = space_.explain(open, *back, "the way back");
        return way;
    }
    way.back = std::move(*back);
    add_boxes(stance, way, way.back);
    return way;
}

const Path& Site::lift(const Stance& stance, Way& way, std::size_t lift) {
    std::optional<Path>& path = way.lifts[lift];
    if (path) return *path;
    const ManipulatorModel& model = space_.model();
    path = model.straight(space_.home(stance.base), way.arm, legs_[lift]);
    if (!path) {
        path.emplace();
        if (!way.stuck) way.stuck = unreachable("the arm cannot make the lift");
        return *path;
    }
    const ProbeOf holding{.probe = Probe::holding_arm, .held = held_, .base = stance.base};
    if (is_path_free(*space_.checker(holding), *path, model.options.certified)) {
        add_boxes(stance, way, *path);
        std::erase_if(way.obstacles, [](const auto& entry) { return entry.second.far; });
    } else {
        if (!way.stuck || way.stuck->reason == Reason::kinematics)
            way.stuck = space_.explain(holding, *path, "the lift");
        path->clear();
    }
    return *path;
}

/// Between two waypoints a link leaves the ball around it at the first by no more than the variables' changes
/// times the length of the arm.
void Site::add_boxes(const Stance& stance, Way& way, const Path& path) const {
    const ManipulatorModel& model = space_.model();
    const Robot& robot = space_.bare_arm();
    std::vector<Pose> poses(robot.links.size());
    std::vector<bool> seen(robot.links.size(), false);
    std::vector<AxisBox> boxes(robot.links.size());
    Configuration configuration = space_.home(stance.base);
    const auto change = [&](std::size_t i) {
        double sum = 0;
        for (std::size_t v = 0; v < path[i].size(); ++v) sum += std::abs(path[i + 1][v] - path[i][v]);
        return sum;
    };
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double after = i + 1 < path.size() ? change(i) : 0;
        const double before = i > 0 ? change(i - 1) : 0;
        const double slack = 0.5 * std::max(after, before) * model.reach_radius();
        robot.insert(model.group(model.arm), path[i], configuration);
        forward_kinematics(robot, configuration, poses);
        for (std::size_t link = 0; link < poses.size(); ++link) {
            const Ball& bound = robot.links[link].bound;
            if (bound.radius <= 0) continue;
            bool empty = !seen[link];
            include(boxes[link], empty, box_around(poses[link] * bound.center, bound.radius + slack));
            seen[link] = true;
        }
    }
    for (std::size_t link = 0; link < boxes.size(); ++link)
        if (seen[link]) way.boxes.push_back(boxes[link]);
}

const ActionFailure* Site::stopped(std::size_t part, const Stance& stance, Way& way, int body, const Pose& pose,
                                   SkillSpace::Id standing) {
    const auto [at, is_new] = way.obstacles.try_emplace(standing);
    Obstacle& found = at->second;
    if (is_new) {
        const AxisBox box = extent(space_.body(body).shapes, pose);
        found.far = std::ranges::none_of(way.boxes, [&](const AxisBox& link) { return link.overlaps(box); });
    }
    if (found.far) return nullptr;
    const ProbeOf bare{.probe = Probe::bare_arm, .standing = standing, .base = stance.base};
    return part == 0 ? decide(found, 0, bare, way.back, "the arm")
                     : decide(found, part, bare, *way.lifts[part - 1], "the arm as it lifts");
}

}  // namespace praxis::tamp
