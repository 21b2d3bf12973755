#include "tamp/manipulation/skill_run.hpp"

#include <algorithm>

#include "tamp/sampling/base_poses.hpp"

namespace praxis::tamp {

namespace {

Path reversed(Path path) {
    std::ranges::reverse(path);
    return path;
}

Vector3 approach_of(const Pose& tool) {
    return tool.linear().col(2);
}

}  // namespace

ActionResult SkillRun::pick(int body, const Grasp& grasp) {
    const Vector3 around = (*state_.world)[body].pose.translation();
    return from_base_poses(around, [&] { return pick_from_here(body, grasp); });
}

ActionResult SkillRun::place(int body, const Grasp& grasp, const Pose& pose) {
    if (model_.gripper >= 0) {
        model_.robot->insert(model_.group(model_.gripper), model_.fingers(model_.grip(grasp)),
                             state_.configuration);
    }
    return from_base_poses(pose.translation(), [&] { return place_from_here(body, grasp, pose); });
}

template <class Attempt>
ActionResult SkillRun::from_base_poses(const Vector3& around, Attempt&& attempt) {
    const State begin = state_;
    const auto done = [&] { return ActionResult{ActionMotion{std::move(pieces_)}, {}}; };
    if (model_.base < 0) {
        if (attempt()) return done();
        return {std::nullopt, log_.take()};
    }
    const Group& base = model_.group(model_.base);
    const BasePoseOptions ring{model_.options.base_nearest, model_.options.base_furthest,
                               model_.options.base_poses};
    const Configuration now = model_.robot->extract(base, begin.configuration);
    for (const Configuration& pose : make_base_poses(around, now, ring)) {
        if (out_of_budget() || hopeless_) break;
        state_ = begin;
        pieces_.clear();
        if (!model_.robot->within_limits(base, pose)) continue;
        const auto checker = model_.checker(state_.world, model_.base, state_.configuration);
        if (!checker->is_free(pose)) {
            log_.add_contact(*checker, pose, "the base beside it");
            continue;
        }
        model_.robot->insert(base, pose, state_.configuration);
        if (!attempt()) continue;
        // Drives are planned last: they take longest, and where the arm cannot reach there is no need for
        // them.
        const auto back = model_.checker(state_.world, model_.base, state_.configuration);
        const Configuration home = model_.robot->extract(base, begin.configuration);
        if (!travel(*back, Kind::base, model_.base, home, "the drive back", true)) continue;
        std::vector<MotionPiece> skill = std::move(pieces_);
        state_ = begin;
        pieces_.clear();
        if (!travel(*checker, Kind::base, model_.base, pose, "the drive of the base", true)) continue;
        std::ranges::move(skill, std::back_inserter(pieces_));
        return done();
    }
    return {std::nullopt, log_.take()};
}

bool SkillRun::pick_from_here(int body, const Grasp& grasp) {
    const Pose target = (*state_.world)[body].pose * grasp.body_in_tool.inverse();
    const State begin = state_;
    for (int number = 0; number < model_.options.arm_configurations; ++number) {
        const std::uint64_t other = variation_ * 1000 + static_cast<std::uint64_t>(number);
        if (out_of_budget()) return false;
        const std::optional<Configuration> arm = model_.reach(begin.configuration, target, other);
        if (!arm) {
            if (number == 0) log_.add_unreachable("the arm does not reach the grasp", true);
            return false;
        }
        state_ = begin;
        pieces_.clear();
        if (pick_with(body, grasp, *arm)) return true;
        if (hopeless_) return false;
    }
    return false;
}

bool SkillRun::pick_with(int body, const Grasp& grasp, const Configuration& arm) {
    const int group = model_.arm;
    move_fingers(model_.effector.max_opening);
    const Configuration open = state_.configuration;
    const auto empty = model_.checker(state_.world, group, open);
    if (!empty->is_free(arm)) {
        return refuse(*empty, arm, "the grasp");
    }
    Configuration at_grasp = open;
    model_.robot->insert(model_.group(group), arm, at_grasp);
    const Pose tool = model_.tool(at_grasp);
    const std::optional<Path> back =
        free_line(*empty, arm, {{-model_.options.approach * approach_of(tool)}}, "the approach");
    if (!back) return false;

    Attachment held = model_.hold(grasp);
    World grasped = state_.world->with_attached(body, held);
    Configuration closed = at_grasp;
    if (model_.gripper >= 0) {
        model_.robot->insert(model_.group(model_.gripper), model_.fingers(model_.grip(grasp)), closed);
    }
    const auto holding = model_.checker(std::make_shared<const World>(grasped), group, closed);
    const std::optional<Path> lift = free_line(*holding, arm, ways_up(approach_of(tool)), "the lift");
    if (!lift) return false;

    if (!travel(*empty, Kind::transit, group, back->back(), "the way to it", true)) return false;
    add(Kind::approach, group, reversed(*back));
    move_fingers(model_.grip(grasp));
    pieces_.push_back({.kind = Kind::gripper, .group = group, .attach = {{body, std::move(held)}}});
    set_world(std::move(grasped));
    add(Kind::retreat, group, *lift);
    return fold(Kind::transfer);
}

bool SkillRun::place_from_here(int body, const Grasp& grasp, const Pose& pose) {
    const Pose target = pose * grasp.body_in_tool.inverse();
    const State begin = state_;
    for (int number = 0; number < model_.options.arm_configurations; ++number) {
        const std::uint64_t other = variation_ * 1000 + static_cast<std::uint64_t>(number);
        if (out_of_budget()) return false;
        const std::optional<Configuration> arm = model_.reach(begin.configuration, target, other);
        if (!arm) {
            if (number == 0) log_.add_unreachable("the arm does not reach the place", true);
            return false;
        }
        state_ = begin;
        pieces_.clear();
        if (place_with(body, grasp, pose, *arm)) return true;
        if (hopeless_) return false;
    }
    return false;
}

bool SkillRun::place_with(int body, const Grasp&, const Pose& pose, const Configuration& arm) {
    const int group = model_.arm;
    const auto holding = model_.checker(state_.world, group, state_.configuration);
    if (!holding->is_free(arm)) {
        return refuse(*holding, arm, "the place");
    }
    Configuration at_place = state_.configuration;
    model_.robot->insert(model_.group(group), arm, at_place);
    const Pose tool = model_.tool(at_place);
    const std::optional<Path> up = free_line(*holding, arm, ways_up(approach_of(tool)), "the way down");
    if (!up) return false;

    World released = state_.world->with_pose(body, pose);
    Configuration open = at_place;
    if (model_.gripper >= 0) {
        model_.robot->insert(model_.group(model_.gripper), model_.fingers(model_.effector.max_opening), open);
    }
    const auto empty = model_.checker(std::make_shared<const World>(released), group, open);
    if (!empty->is_free(arm)) {
        return refuse(*empty, arm, "the hand as it opens");
    }
    const std::optional<Path> back =
        free_line(*empty, arm, {{-model_.options.approach * approach_of(tool)}}, "the hand's way back");
    if (!back) return false;

    if (!travel(*holding, Kind::transfer, group, up->back(), "the way to its place", true)) return false;
    add(Kind::approach, group, reversed(*up));
    pieces_.push_back({.kind = Kind::gripper, .group = group, .detach = {{body, pose}}});
    set_world(std::move(released));
    move_fingers(model_.effector.max_opening);
    add(Kind::retreat, group, *back);
    return fold(Kind::transit);
}

bool SkillRun::fold(Kind kind) {
    const auto checker = model_.checker(state_.world, model_.arm, state_.configuration);
    const Configuration home = model_.robot->extract(model_.group(model_.arm), model_.home);
    return travel(*checker, kind, model_.arm, home, "the way home", true);
}

void SkillRun::add(Kind kind, int group, Path path) {
    model_.robot->insert(model_.group(group), path.back(), state_.configuration);
    pieces_.push_back({.kind = kind, .group = group, .path = std::move(path)});
}

void SkillRun::move_fingers(double opening) {
    if (model_.gripper < 0) return;
    Configuration now = model_.robot->extract(model_.group(model_.gripper), state_.configuration);
    Configuration then = model_.fingers(opening);
    if (now != then) add(Kind::gripper, model_.gripper, {std::move(now), std::move(then)});
}

bool SkillRun::travel(CollisionChecker& checker, Kind kind, int group, const Configuration& goal,
                      const std::string& phase, bool homing) {
    const Configuration start = model_.robot->extract(model_.group(group), state_.configuration);
    if (start == goal) return true;
    MotionResult found = model_.travel(checker, start, goal, variation_, budget_);
    switch (found.status) {
        case MotionStatus::solved:
            add(kind, group, std::move(found.path));
            pieces_.back().homing = homing;
            return true;
        case MotionStatus::start_in_collision:
            log_.add_contact(checker, start, "the start of " + phase);
            break;
        case MotionStatus::goal_in_collision:
            log_.add_contact(checker, goal, "the end of " + phase);
            break;
        case MotionStatus::start_out_of_limits:
        case MotionStatus::goal_out_of_limits:
            log_.add_unreachable(phase + " leaves the limits", true);
            break;
        case MotionStatus::not_found: {
            std::vector<int> bodies;
            for (const Obstruction& met : found.obstructions) {
                if (met.who.kind == Participant::Kind::body) bodies.push_back(met.who.index);
            }
            log_.add_no_path(checker.problem(), bodies, phase);
        }
    }
    return false;
}

std::optional<Path> SkillRun::free_line(CollisionChecker& checker, const Configuration& arm,
                                        const std::vector<std::vector<Vector3>>& ways,
                                        const std::string& phase) {
    const auto is_free = [&](const Path& path) {
        for (std::size_t i = 0; i + 1 < path.size(); ++i) {
            if (!(model_.options.certified ? checker.is_motion_certified(path[i], path[i + 1])
                                           : checker.is_motion_free(path[i], path[i + 1]))) {
                return false;
            }
        }
        return true;
    };
    std::optional<Path> blocked;
    for (const std::vector<Vector3>& legs : ways) {
        std::optional<Path> path = model_.straight(state_.configuration, arm, legs);
        if (!path) continue;
        if (is_free(*path)) return path;
        if (!blocked) blocked = std::move(path);
    }
    if (blocked) {
        hopeless_ = log_.add_blocked_path(checker, *blocked, phase) && ways.size() == 1;
    } else {
        log_.add_unreachable("the arm cannot make " + phase, true);
    }
    return std::nullopt;
}

/// Straight up; under a roof a little up, then back along the hand; where even that is too much, only back.
std::vector<std::vector<Vector3>> SkillRun::ways_up(const Vector3& approach) const {
    const Vector3 back = -model_.options.approach * approach;
    return {{{0, 0, model_.options.lift}}, {{0, 0, model_.options.low_lift}, back}, {back}};
}

bool SkillRun::refuse(CollisionChecker& checker, const Configuration& positions, const std::string& phase) {
    hopeless_ = log_.add_contact(checker, positions, phase);
    return false;
}

bool SkillRun::out_of_budget() {
    if (budget_.exhausted() == Stop::none) return false;
    log_.add_unreachable("the time is up", false);
    return true;
}

}  // namespace praxis::tamp
