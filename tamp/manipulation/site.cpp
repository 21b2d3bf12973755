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
    const bool certified = space_.model().options.certified;
    const auto open = space_.checker({.probe = Probe::open_hand});
    const Configuration& at = hand_back_.front();
    Configuration rest = open->problem().rest;
    std::ranges::copy(at, rest.begin());
    back_box_ = box_of(*open->problem().robot, rest);
    lift_box_ = back_box_;
    back_box_.include(shifted(back_box_, back_));
    if (!is_path_free(*open, hand_back_, certified)) {
        failure_ = space_.explain({.probe = Probe::open_hand}, hand_back_, "the hand");
        return;
    }
    const auto holding = space_.checker({.probe = Probe::holding_hand, .held = held_});
    if (!holding->is_free(at)) {
        failure_ = space_.explain({.probe = Probe::holding_hand, .held = held_}, {at}, "what the hand holds");
        return;
    }
    const World& held = *holding->problem().world;
    lift_box_.include(extent(held[static_cast<int>(held.size()) - 1].model->shapes, pose_));
    AxisBox all = lift_box_;
    for (std::size_t i = 0; i < kLifts; ++i) {
        open_[i] = is_path_free(*holding, hand_lifts_[i], certified);
        if (!open_[i]) continue;
        Vector3 by = Vector3::Zero();
        for (const Vector3& leg : legs_[i]) all.include(shifted(lift_box_, by += leg));
    }
    lift_box_ = all;
    if (open_[0] || open_[1] || open_[2]) return;
    failure_ = space_.explain({.probe = Probe::holding_hand, .held = held_}, hand_lifts_.front(),
                              "the hand as it lifts");
}

const Obstacle& Site::stopped(int body, const Pose& pose, SkillSpace::Id standing) {
    const auto [at, is_new] = obstacles_.try_emplace(standing);
    Obstacle& found = at->second;
    if (!is_new) return found;
    const bool certified = space_.model().options.certified;
    const AxisBox box = extent(space_.body(body).shapes, pose);
    if (box.overlaps(back_box_)) {
        const ProbeOf open{.probe = Probe::open_hand_at, .standing = standing};
        if (!is_path_free(*space_.checker(open), hand_back_, certified)) {
            return found = {kStopsAll, space_.explain(open, hand_back_, "the hand")};
        }
    }
    if (!box.overlaps(lift_box_)) return found;
    const ProbeOf holding{.probe = Probe::holding_hand_at, .standing = standing, .held = held_};
    const auto checker = space_.checker(holding);
    const Configuration& at_target = hand_back_.front();
    if (!checker->is_free(at_target)) {
        return found = {kStopsAll, space_.explain(holding, {at_target}, "what the hand holds")};
    }
    for (std::size_t i = 0; i < kLifts; ++i) {
        if (!open_[i] || is_path_free(*checker, hand_lifts_[i], certified)) continue;
        if (found.stops == 0) found.why = space_.explain(holding, hand_lifts_[i], "the hand as it lifts");
        found.stops |= stops_lift(i);
    }
    return found;
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
    const ProbeOf holding{.probe = Probe::holding_arm, .held = held_, .base = stance.base};
    const auto laden = space_.checker(holding);
    bool any = false;
    for (std::size_t i = 0; i < kLifts; ++i) {
        if (!open_[i]) continue;
        std::optional<Path> lift = model.straight(home, *arm, legs_[i]);
        if (!lift) {
            if (!way.failure) way.failure = unreachable("the arm cannot make the lift");
            continue;
        }
        if (!is_path_free(*laden, *lift, certified)) {
            if (!way.failure || way.failure->reason == Reason::kinematics)
                way.failure = space_.explain(holding, *lift, "the lift");
            continue;
        }
        way.lifts[i] = std::move(*lift);
        any = true;
    }
    if (any) {
        way.failure.reset();
        find_boxes(stance, way);
    }
    return way;
}

/// Between two waypoints a link leaves the ball around it at the first by no more than the variables' changes
/// times the length of the arm.
void Site::find_boxes(const Stance& stance, Way& way) const {
    const ManipulatorModel& model = space_.model();
    const Robot& robot = space_.bare_arm();
    std::vector<Pose> poses(robot.links.size());
    std::vector<bool> seen(robot.links.size(), false);
    std::vector<AxisBox> boxes(robot.links.size());
    Configuration configuration = space_.home(stance.base);
    const auto add = [&](const Path& path) {
        for (std::size_t i = 0; i < path.size(); ++i) {
            double change = 0;
            for (std::size_t v = 0; i + 1 < path.size() && v < path[i].size(); ++v)
                change += std::abs(path[i + 1][v] - path[i][v]);
            double before = 0;
            for (std::size_t v = 0; i > 0 && v < path[i].size(); ++v) before += std::abs(path[i][v] - path[i - 1][v]);
            const double slack = 0.5 * std::max(change, before) * model.reach_radius();
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
    };
    add(way.back);
    for (const Path& lift : way.lifts) add(lift);
    for (std::size_t link = 0; link < boxes.size(); ++link)
        if (seen[link]) way.boxes.push_back(boxes[link]);
}

const Obstacle& Site::stopped(const Stance& stance, Way& way, int body, const Pose& pose,
                              SkillSpace::Id standing) {
    const auto [at, is_new] = way.obstacles.try_emplace(standing);
    Obstacle& found = at->second;
    if (!is_new) return found;
    const AxisBox box = extent(space_.body(body).shapes, pose);
    if (std::ranges::none_of(way.boxes, [&](const AxisBox& link) { return link.overlaps(box); })) return found;
    const bool certified = space_.model().options.certified;
    const ProbeOf bare{.probe = Probe::bare_arm, .standing = standing, .base = stance.base};
    const auto checker = space_.checker(bare);
    if (!is_path_free(*checker, way.back, certified)) {
        return found = {kStopsAll, space_.explain(bare, way.back, "the arm")};
    }
    for (std::size_t i = 0; i < kLifts; ++i) {
        if (way.lifts[i].empty() || is_path_free(*checker, way.lifts[i], certified)) continue;
        if (found.stops == 0) found.why = space_.explain(bare, way.lifts[i], "the arm as it lifts");
        found.stops |= stops_lift(i);
    }
    return found;
}

}  // namespace praxis::tamp
