#include "tamp/manipulation/skill_run.hpp"

#include <algorithm>

#include "tamp/manipulation/drives.hpp"
#include "tamp/motion/certify.hpp"
#include "tamp/motion/shortcut.hpp"

namespace praxis::tamp {

namespace {

using Reason = TrajectoryDocument::Reason;

Path reversed(Path path) {
    std::ranges::reverse(path);
    return path;
}

}  // namespace

SkillRun::SkillRun(SkillSpace& space, Skill skill, const World& world, int body, const Pose& pose,
                   const Grasp& grasp, const Budget& budget, std::uint64_t variation)
    : space_(space),
      model_(space.model()),
      skill_(skill),
      body_(body),
      pose_(pose),
      grasp_(grasp),
      budget_(budget),
      variation_(variation),
      log_((skill == Skill::pick ? "pick '" : "place '") + world[body].model->name + "'"),
      standing_world_(std::make_shared<const World>(world.with_pose(body, pose))),
      holding_world_(std::make_shared<const World>(world.with_attached(body, model_.hold(grasp)))) {
    for (int other = 0; other < static_cast<int>(world.size()); ++other) {
        const BodyState& state = world[other];
        if (other == body || !state.model->movable || state.attachment) continue;
        others_.push_back({other, space.standing(other, state.pose)});
    }
}

ActionResult SkillRun::run(const std::function<Site&()>& find_site) {
    const auto failed = [&] {
        ActionFailure failure = log_.take();
        failure.world = skill_ == Skill::pick ? standing_world_ : holding_world_;
        return ActionResult{std::nullopt, std::move(failure)};
    };
    if (is_taken()) return failed();
    site_ = &find_site();
    if (hand_fails()) return failed();
    for (Stance& stance : site_->stances()) {
        if (out_of_budget()) break;
        if (try_stance(stance)) return {std::move(motion_), {}};
    }
    return failed();
}

bool SkillRun::is_taken() {
    std::vector<int> bodies;
    for (const Other& other : others_)
        if (space_.touch(body_, pose_, other.body, (*standing_world_)[other.body].pose))
            bodies.push_back(other.body);
    if (bodies.empty()) return false;
    ActionFailure why{.reason = Reason::collision};
    for (const int body : bodies)
        why.contacts.push_back({{Participant::Kind::body, std::min(body, body_)},
                                {Participant::Kind::body, std::max(body, body_)}});
    why.message = "the place is taken by '" + (*standing_world_)[bodies.front()].model->name + "'";
    log_.add_blocked(std::move(bodies), why);
    return true;
}

std::vector<int> SkillRun::hand_stoppers(std::size_t part, const ActionFailure*& why) {
    std::vector<int> bodies;
    for (const Other& other : others_) {
        const Pose& pose = (*standing_world_)[other.body].pose;
        const ActionFailure* stopped = site_->stopped(part, other.body, pose, other.standing);
        if (stopped == nullptr) continue;
        bodies.push_back(other.body);
        if (why == nullptr) why = stopped;
    }
    return bodies;
}

std::vector<int> SkillRun::arm_stoppers(std::size_t part, const Stance& stance, Way& way,
                                        const ActionFailure*& why) {
    std::vector<int> bodies;
    for (const Other& other : others_) {
        const Pose& pose = (*standing_world_)[other.body].pose;
        const ActionFailure* stopped = site_->stopped(part, stance, way, other.body, pose, other.standing);
        if (stopped == nullptr) continue;
        bodies.push_back(other.body);
        if (why == nullptr) why = stopped;
    }
    return bodies;
}

const SkillRun::Stopped& SkillRun::lift_stoppers(std::size_t lift) {
    std::optional<Stopped>& known = lift_stoppers_[lift];
    if (!known) {
        known = Stopped();
        known->bodies = hand_stoppers(1 + lift, known->why);
    }
    return *known;
}

/// The hand alone is stopped.
bool SkillRun::hand_fails() {
    if (site_->failure()) {
        log_.add_fixed(*site_->failure());
        return true;
    }
    const ActionFailure* why = nullptr;
    std::vector<int> all = hand_stoppers(0, why);
    if (!all.empty()) {
        log_.add_blocked(std::move(all), *why);
        return true;
    }
    for (std::size_t i = 0; i < kLifts; ++i)
        if (site_->can_lift(i) && lift_stoppers(i).bodies.empty()) return false;
    for (std::size_t i = 0; i < kLifts; ++i)
        if (site_->can_lift(i)) log_.add_blocked(lift_stoppers(i).bodies, *lift_stoppers(i).why);
    return true;
}

bool SkillRun::try_stance(Stance& stance) {
    if (model_.base >= 0) {
        const auto base = checker(skill_ == Skill::place, model_.base, home({}, skill_ == Skill::place));
        if (!base->is_free(stance.positions)) {
            const ActionFailure why = contact_on_path(*base, {stance.positions}, "the base beside it");
            std::vector<int> bodies;
            bool fixed = why.contacts.empty();
            for (const Contact& contact : why.contacts) {
                const std::vector<int> movable = movable_in({contact});
                fixed = fixed || movable.empty();
                bodies.insert(bodies.end(), movable.begin(), movable.end());
            }
            if (fixed)
                log_.add_fixed(why);
            else
                log_.add_blocked(std::move(bodies), why);
            return false;
        }
    }
    if (hard_drive_ && !is_reachable(stance, false)) return false;
    const auto count = static_cast<std::uint64_t>(model_.options.arm_configurations);
    for (std::uint64_t i = 0; i < count; ++i) {
        if (out_of_budget()) return false;
        Way& way = site_->way(stance, variation_ * count + i);
        if (way.arm.empty()) {
            if (i == 0) log_.add_fixed(*way.failure);
            return false;
        }
        if (try_way(stance, way)) return true;
    }
    return false;
}

bool SkillRun::try_way(Stance& stance, Way& way) {
    if (way.failure) {
        log_.add_fixed(*way.failure);
        return false;
    }
    const ActionFailure* why = nullptr;
    std::vector<int> all = arm_stoppers(0, stance, way, why);
    if (!all.empty()) {
        log_.add_blocked(std::move(all), *why);
        return false;
    }
    std::size_t lift = 0;
    std::vector<Stopped> stopped;
    for (; lift < kLifts; ++lift) {
        if (!site_->can_lift(lift)) continue;
        if (site_->lift(stance, way, lift).empty()) continue;
        Stopped by = lift_stoppers(lift);
        const std::vector<int> of_arm = arm_stoppers(1 + lift, stance, way, by.why);
        by.bodies.insert(by.bodies.end(), of_arm.begin(), of_arm.end());
        if (by.bodies.empty()) break;
        stopped.push_back(std::move(by));
    }
    if (lift == kLifts) {
        for (Stopped& by : stopped) log_.add_blocked(std::move(by.bodies), *by.why);
        if (stopped.empty()) log_.add_fixed(*way.stuck);
        return false;
    }
    if (!confirm(stance, way, lift)) return false;
    std::optional<Path> transit = travel(way.transit, stance, false, way.back.back(), "the way without it");
    if (!transit) return false;
    std::optional<Path> transfer =
        travel(way.transfers[lift], stance, true, way.lifts[lift]->back(), "the way with it");
    if (!transfer) return false;
    Path there, away;
    if (!drive(stance, there, away)) return false;
    assemble(stance, way, lift, std::move(*transit), std::move(*transfer), std::move(there), std::move(away));
    return true;
}

bool SkillRun::confirm(const Stance& stance, const Way& way, std::size_t lift) {
    std::vector<SkillSpace::Id> near;
    std::vector<int> bodies;
    for (const Other& other : others_) {
        if (!site_->is_near(other.body, (*standing_world_)[other.body].pose)) continue;
        near.push_back(other.standing);
        bodies.push_back(other.body);
    }
    if (near.empty()) return true;
    const bool certified = model_.options.certified;
    if (is_path_free(*space_.checker_among(near, {}, stance.base), way.back, certified) &&
        is_path_free(*space_.checker_among(near, site_->held(), stance.base), *way.lifts[lift], certified)) {
        return true;
    }
    log_.add_no_path(bodies, {.reason = Reason::collision,
                              .message = "the hand only just touches what it passes by",
                              .definite = false});
    return false;
}

bool SkillRun::is_free_of_others(KnownPath& known, const Stance& stance, bool holding) const {
    std::vector<SkillSpace::Id> unknown;
    for (const Other& other : others_)
        if (!known.free_of.contains(other.standing)) unknown.push_back(other.standing);
    if (unknown.empty()) return true;
    const auto held = holding ? std::optional(site_->held()) : std::nullopt;
    if (!is_path_free(*space_.checker_among(unknown, held, stance.base), known.found.path,
                      model_.options.certified)) {
        return false;
    }
    known.free_of.insert(unknown.begin(), unknown.end());
    return true;
}

std::optional<Path> SkillRun::travel(std::optional<KnownPath>& known, const Stance& stance, bool holding,
                                     const Configuration& end, const std::string& phase) {
    const Configuration rest = home(stance, holding);
    const Configuration start = model_.robot->extract(model_.group(model_.arm), rest);
    if (!known) {
        const ProbeOf probe{holding ? Probe::holding_arm : Probe::passing_arm, site_->standing(),
                            site_->held(), stance.base};
        known.emplace();
        known->found = start == end ? MotionResult{.status = MotionStatus::solved, .path = {start}}
                                    : model_.travel(*space_.checker(probe), start, end, 0, budget_);
    }
    std::vector<int> blockers;
    if (known->found.status == MotionStatus::solved) {
        if (is_free_of_others(*known, stance, holding)) return known->found.path;
        for (const Other& other : others_) {
            const ProbeOf bare{Probe::bare_arm, other.standing, 0, stance.base};
            if (!is_path_free(*space_.checker(bare), known->found.path, false))
                blockers.push_back(other.body);
        }
    }
    const auto all = checker(holding, model_.arm, rest);
    MotionResult found = model_.travel(*all, start, end, variation_, budget_);
    if (found.status == MotionStatus::solved) return std::move(found.path);
    log_no_path(found, blockers, phase);
    return std::nullopt;
}

bool SkillRun::drive(const Stance& stance, Path& there, Path& away) {
    constexpr int kEasy = 300;  // iterations
    if (model_.base < 0) return true;
    const Configuration begin = model_.robot->extract(model_.group(model_.base), model_.home);
    if (begin == stance.positions) return true;
    const bool laden_there = skill_ == Skill::place;
    const auto find = [&](CollisionChecker& base, bool laden) -> std::optional<Path> {
        if (!hard_drive_) {
            MotionResult found = model_.travel(base, begin, stance.positions, variation_, budget_, kEasy);
            if (found.status == MotionStatus::solved) return std::move(found.path);
            hard_drive_ = true;
        }
        return drive_on_lattice(stance, laden);
    };
    const auto first = checker(laden_there, model_.base, home({}, laden_there));
    std::optional<Path> path = find(*first, laden_there);
    if (!path) return false;
    there = std::move(*path);
    const auto second = checker(!laden_there, model_.base, home({}, !laden_there));
    if (!is_path_free(*second, there, model_.options.certified)) {
        path = find(*second, !laden_there);
        if (!path) return false;
        away = std::move(*path);
    } else {
        away = there;
    }
    std::ranges::reverse(away);
    return true;
}

std::vector<SkillSpace::Id> SkillRun::standing(bool laden) const {
    std::vector<SkillSpace::Id> ids;
    for (const Other& other : others_) ids.push_back(other.standing);
    if (!laden) ids.push_back(site_->standing());
    return ids;
}

bool SkillRun::is_reachable(const Stance& stance, bool laden) {
    const auto held = laden ? std::optional(site_->held()) : std::nullopt;
    const LatticeSearch::Way& way = space_.drives().way(standing(laden), held, stance.positions);
    if (way.found && way.bodies.empty()) return true;
    ActionFailure why{
        .reason = Reason::no_path, .message = "there is no way for the base", .definite = false};
    std::vector<int> bodies;
    for (const int number : way.bodies)
        if (const auto other = static_cast<std::size_t>(number); other < others_.size())
            bodies.push_back(others_[other].body);
    why.message += in_the_way(bodies);
    if (bodies.empty())
        log_.add_fixed(why);
    else
        log_.add_blocked(std::move(bodies), why);
    return false;
}

std::optional<Path> SkillRun::drive_on_lattice(const Stance& stance, bool laden) {
    if (!is_reachable(stance, laden)) return std::nullopt;
    const auto held = laden ? std::optional(site_->held()) : std::nullopt;
    Path path =
        space_.drives().path(space_.drives().way(standing(laden), held, stance.positions), stance.positions);
    const auto base = checker(laden, model_.base, home({}, laden));
    shortcut(*base, path, {.seed = model_.options.seed + variation_, .budget = budget_});
    if (is_path_free(*base, path, model_.options.certified)) return path;
    const Budget budget = budget_.within(model_.options.plan_time);
    const std::uint64_t seed = model_.options.seed + variation_;
    if (certify(*base, path, {.seed = seed, .budget = budget})) return path;
    log_.add_no_path(
        {},
        {.reason = Reason::no_path, .message = "no path found for the drive of the base", .definite = false});
    return std::nullopt;
}

void SkillRun::log_no_path(const MotionResult& found, const std::vector<int>& blockers,
                           const std::string& phase) {
    ActionFailure why{.reason = Reason::no_path, .message = "no path found for " + phase, .definite = false};
    std::vector<int> bodies = blockers;
    if (found.status != MotionStatus::not_found) {
        why.message = phase + ": " + std::string(to_string(found.status));
        bodies = movable_in(found.contacts);
        if (bodies.size() > 1) bodies.erase(bodies.begin() + 1, bodies.end());
    } else if (bodies.empty()) {
        for (const Obstruction& met : found.obstructions)
            if (met.who.kind == Participant::Kind::body &&
                std::ranges::find(others_, met.who.index, &Other::body) != others_.end())
                bodies.push_back(met.who.index);
    }
    why.message += in_the_way(bodies);
    log_.add_no_path(bodies, why);
}

std::string SkillRun::in_the_way(const std::vector<int>& bodies) const {
    std::string text;
    for (const int body : bodies)
        text += (text.empty() ? "; in the way: '" : ", '") + (*standing_world_)[body].model->name + "'";
    return text;
}

std::vector<int> SkillRun::movable_in(const std::vector<Contact>& contacts) const {
    std::vector<int> bodies;
    for (const Contact& contact : contacts)
        for (const Participant& who : {contact.first, contact.second})
            if (who.kind == Participant::Kind::body &&
                std::ranges::find(others_, who.index, &Other::body) != others_.end())
                bodies.push_back(who.index);
    return bodies;
}

void SkillRun::assemble(const Stance&, const Way& way, std::size_t lift, Path transit, Path transfer,
                        Path there, Path away) {
    std::vector<MotionPiece>& pieces = motion_.pieces;
    const auto add = [&](Kind kind, int group, Path path, bool homing) {
        if (path.size() > 1)
            pieces.push_back({.kind = kind, .group = group, .path = std::move(path), .homing = homing});
    };
    const auto fingers = [&](double from, double to) {
        if (model_.gripper < 0) return;
        Configuration now = model_.fingers(from);
        Configuration then = model_.fingers(to);
        if (now != then) add(Kind::gripper, model_.gripper, {std::move(now), std::move(then)}, false);
    };
    const double open = model_.effector.max_opening;
    const double closed = ManipulatorModel::grip(grasp_);
    add(Kind::base, model_.base, std::move(there), true);
    if (skill_ == Skill::pick) {
        add(Kind::transit, model_.arm, std::move(transit), true);
        add(Kind::approach, model_.arm, reversed(way.back), false);
        fingers(open, closed);
        pieces.push_back(
            {.kind = Kind::gripper, .group = model_.arm, .attach = {{body_, model_.hold(grasp_)}}});
        add(Kind::retreat, model_.arm, *way.lifts[lift], false);
        add(Kind::transfer, model_.arm, reversed(std::move(transfer)), true);
    } else {
        add(Kind::transfer, model_.arm, std::move(transfer), true);
        add(Kind::approach, model_.arm, reversed(*way.lifts[lift]), false);
        pieces.push_back({.kind = Kind::gripper, .group = model_.arm, .detach = {{body_, pose_}}});
        fingers(closed, open);
        add(Kind::retreat, model_.arm, way.back, false);
        add(Kind::transit, model_.arm, reversed(std::move(transit)), true);
    }
    add(Kind::base, model_.base, std::move(away), true);
}

std::unique_ptr<CollisionChecker> SkillRun::checker(bool holding, int group,
                                                    const Configuration& rest) const {
    return model_.checker(holding ? holding_world_ : standing_world_, group, rest);
}

Configuration SkillRun::home(const Stance& stance, bool holding) const {
    return holding ? space_.home(stance.base, site_->held()) : space_.home(stance.base);
}

bool SkillRun::out_of_budget() {
    if (budget_.exhausted() == Stop::none) return false;
    log_.add_fixed({.reason = Reason::kinematics, .message = "the time is up", .definite = false});
    return true;
}

}  // namespace praxis::tamp
