#include "tamp/manipulation/skill_space.hpp"

#include <algorithm>
#include <numeric>

#include "tamp/collision/fast_checker.hpp"
#include "tamp/geometry/extent.hpp"
#include "tamp/manipulation/drives.hpp"
#include "tamp/manipulation/failure_log.hpp"

namespace praxis::tamp {

namespace {

/// Checkers that are kept at a time.
constexpr std::size_t kMostCheckers = 512;

void append(std::string& key, const double* numbers, std::size_t count) {
    key.append(reinterpret_cast<const char*>(numbers), count * sizeof(double));
}

std::string key_of(char kind, int body, const Pose& pose) {
    std::string key(1, kind);
    key += std::to_string(body) + ":";
    append(key, pose.data(), 16);
    return key;
}

}  // namespace

SkillSpace::SkillSpace(const ManipulatorModel& model, const World& world)
    : model_(model),
      world_(world),
      hand_(make_flying_hand(*model.robot, model.effector, model.home)),
      bare_arm_(make_bare_arm(*model.robot, model.effector)) {
    all_links_.resize(model.robot->links.size());
    std::iota(all_links_.begin(), all_links_.end(), 0);
    for (int body = 0; body < static_cast<int>(world.size()); ++body)
        if (!world[body].model->movable) fixed_.push_back(body);
    for (const BodyState& state : world.bodies())
        solids_.push_back(state.model->movable ? model.solids()->make(state.model->shapes)
                                               : std::vector<Solid>());
    base(model.base < 0 ? Configuration() : model.robot->extract(model.group(model.base), model.home));
}

SkillSpace::~SkillSpace() = default;

Drives& SkillSpace::drives() {
    if (!drives_) drives_ = std::make_unique<Drives>(*this);
    return *drives_;
}

bool SkillSpace::matches(const World& world) const {
    if (world.size() != world_.size()) return false;
    for (int body = 0; body < static_cast<int>(world.size()); ++body)
        if (world[body].model != world_[body].model) return false;
    return std::ranges::all_of(
        fixed_, [&](int body) { return world[body].pose.matrix() == world_[body].pose.matrix(); });
}

SkillSpace::Id SkillSpace::number(std::string key, std::size_t next) {
    return numbers_.try_emplace(std::move(key), static_cast<Id>(next)).first->second;
}

SkillSpace::Id SkillSpace::standing(int body, const Pose& pose) {
    const Id id = number(key_of('s', body, pose), standing_.size());
    if (id == standing_.size()) standing_.push_back({body, pose});
    return id;
}

SkillSpace::Id SkillSpace::held(int body, const Grasp& grasp) {
    std::string key = key_of('h', body, grasp.body_in_tool);
    append(key, &grasp.opening, 1);
    const Id id = number(std::move(key), held_.size());
    if (id == held_.size()) held_.push_back({body, grasp});
    return id;
}

SkillSpace::Id SkillSpace::base(const Configuration& positions) {
    std::string key = "b";
    append(key, positions.data(), positions.size());
    const Id id = number(std::move(key), bases_.size());
    if (id == bases_.size()) bases_.push_back(positions);
    return id;
}

Configuration SkillSpace::home(Id base) const {
    Configuration home = model_.home;
    if (model_.base >= 0) model_.robot->insert(model_.group(model_.base), bases_[base], home);
    return home;
}

Configuration SkillSpace::home(Id base, Id held) const {
    Configuration closed = home(base);
    if (model_.gripper >= 0) {
        model_.robot->insert(model_.group(model_.gripper),
                             model_.fingers(ManipulatorModel::grip(held_[held].grasp)), closed);
    }
    return closed;
}

std::vector<int> SkillSpace::bodies_of(const ProbeOf& probe) const {
    const auto standing = [&] { return standing_[probe.standing].body; };
    const auto held = [&] { return held_[probe.held].body; };
    std::vector<int> bodies;
    switch (probe.probe) {
        case Probe::open_arm:
        case Probe::passing_arm:
            bodies = fixed_;
            bodies.push_back(standing());
            break;
        case Probe::holding_arm:
        case Probe::holding_hand:
            bodies = fixed_;
            bodies.push_back(held());
            break;
        case Probe::open_hand:
            bodies = fixed_;
            break;
        case Probe::bare_arm:
        case Probe::open_hand_at:
            bodies = {standing()};
            break;
        case Probe::holding_hand_at:
            bodies = {standing(), held()};
    }
    return bodies;
}

std::shared_ptr<CollisionChecker> SkillSpace::checker(const ProbeOf& probe) {
    const Tuple key = {static_cast<Id>(probe.probe), probe.standing, probe.held, probe.base};
    const auto known = checkers_.find(key);
    if (known != checkers_.end()) return known->second;
    if (checkers_.size() >= kMostCheckers) checkers_.clear();
    return checkers_[key] = make(probe);
}

std::shared_ptr<CollisionChecker> SkillSpace::make(const ProbeOf& probe) const {
    const bool arm = probe.probe <= Probe::bare_arm;
    const bool stands = probe.probe == Probe::open_arm || probe.probe == Probe::passing_arm ||
                        probe.probe == Probe::bare_arm || probe.probe == Probe::open_hand_at ||
                        probe.probe == Probe::holding_hand_at;
    const bool holds = probe.probe == Probe::holding_arm || probe.probe == Probe::holding_hand ||
                       probe.probe == Probe::holding_hand_at;
    World world = world_;
    if (stands) {
        const Standing& one = standing_[probe.standing];
        world = world.with_pose(one.body, one.pose);
    }
    const std::vector<int> bodies = bodies_of(probe);
    world = part_of(world, bodies, arm ? all_links_ : hand_.links);
    if (holds) {
        const Attachment hold = model_.hold(held_[probe.held].grasp);
        world = world.with_attached(static_cast<int>(bodies.size()) - 1, arm ? hold : hand_.attachment(hold));
    }
    if (probe.probe == Probe::open_arm) {
        const Participant own{Participant::Kind::body, static_cast<int>(bodies.size()) - 1};
        for (const int link : model_.effector.links)
            world = world.with_allowed({Participant::Kind::link, link}, own);
    }
    const Configuration rest = holds ? home(probe.base, probe.held) : home(probe.base);
    CollisionProblem problem;
    problem.world = std::make_shared<const World>(std::move(world));
    problem.robot = probe.probe == Probe::bare_arm ? bare_arm_ : arm ? model_.robot : hand_.robot;
    problem.group = arm ? model_.arm : hand_.group;
    problem.rest = arm ? rest : hand_.rest(rest);
    return make_fast_checker(problem, model_.solids());
}

bool SkillSpace::touch(int first, const Pose& first_pose, int second, const Pose& second_pose) const {
    using Kind = Participant::Kind;
    for (const Solid& one : solids_[static_cast<std::size_t>(first)]) {
        const Pose one_pose = first_pose * one.pose;
        const AxisBox box = moved(one.extent, one_pose);
        for (const Solid& other : solids_[static_cast<std::size_t>(second)]) {
            const Pose other_pose = second_pose * other.pose;
            if (box.overlaps(moved(other.extent, other_pose)) &&
                tamp::touch(one, one_pose, other, other_pose)) {
                return !world_.allowed({Kind::body, first}, {Kind::body, second});
            }
        }
    }
    return false;
}

/// Checked a little to every side, too, since an arm follows a straight line not quite exactly.
bool SkillSpace::fits(Id held) {
    Held& one = held_[held];
    if (one.fits) return *one.fits;
    constexpr double kAside = 5e-4;
    constexpr double kStep = 2e-3;
    const Pose tool = one.grasp.body_in_tool.inverse();
    const Vector3 back = -model_.options.approach * tool.linear().col(2);
    const auto open = checker({Probe::open_hand_at, standing(one.body, Pose::Identity()), 0, 0});
    one.fits = true;
    for (const Vector3& aside : {Vector3(0, 0, 0), Vector3(0, kAside, 0), Vector3(0, -kAside, 0),
                                 Vector3(kAside, 0, 0), Vector3(-kAside, 0, 0)}) {
        Pose hand = tool * model_.effector.tool.inverse();
        hand.translation() += tool.linear() * aside;
        const Configuration from = FlyingHand::at(hand);
        Configuration to = from;
        for (std::size_t k = 0; k < 3; ++k) to[k] += back[static_cast<Eigen::Index>(k)];
        if (!open->is_motion_free(from, to, kStep)) one.fits = false;
    }
    return *held_[held].fits;
}

bool SkillSpace::can_carry(Id held) {
    if (!held_[held].can_carry) {
        const Configuration arm = model_.robot->extract(model_.group(model_.arm), model_.home);
        held_[held].can_carry = checker({Probe::holding_arm, 0, held, 0})->is_free(arm);
    }
    return *held_[held].can_carry;
}

std::unique_ptr<CollisionChecker> SkillSpace::checker_among(std::span<const Id> standing,
                                                            std::optional<Id> held, Id base) const {
    World world = world_;
    std::vector<int> bodies;
    for (const Id id : standing) {
        bodies.push_back(standing_[id].body);
        world = world.with_pose(standing_[id].body, standing_[id].pose);
    }
    if (held) bodies.push_back(held_[*held].body);
    world = part_of(world, bodies, all_links_);
    if (held)
        world = world.with_attached(static_cast<int>(bodies.size()) - 1, model_.hold(held_[*held].grasp));
    return model_.checker(std::make_shared<const World>(std::move(world)), model_.arm,
                          held ? home(base, *held) : home(base));
}

std::unique_ptr<CollisionChecker> SkillSpace::base_checker(std::optional<Id> standing,
                                                           std::optional<Id> held) const {
    World world = world_;
    std::vector<int> bodies = standing ? std::vector<int>{standing_[*standing].body} : fixed_;
    if (standing) world = world.with_pose(standing_[*standing].body, standing_[*standing].pose);
    if (held) bodies.push_back(held_[*held].body);
    world = part_of(world, bodies, all_links_);
    if (held)
        world = world.with_attached(static_cast<int>(bodies.size()) - 1, model_.hold(held_[*held].grasp));
    return model_.checker(std::make_shared<const World>(std::move(world)), model_.base,
                          held ? home({}, *held) : home({}));
}

Ball SkillSpace::standing_bound(Id standing) const {
    const Standing& one = standing_[standing];
    Ball ball = bound_of(solids_[static_cast<std::size_t>(one.body)]);
    ball.center = one.pose * ball.center;
    return ball;
}

Ball SkillSpace::held_bound(Id held) const {
    Ball ball = bound_of(solids_[static_cast<std::size_t>(held_[held].body)]);
    ball.center = held_[held].grasp.body_in_tool * ball.center;
    return ball;
}

AxisBox SkillSpace::extent() const {
    std::optional<AxisBox> all;
    for (const BodyState& state : world_.bodies()) {
        if (state.model->shapes.empty()) continue;
        const AxisBox box = tamp::extent(state.model->shapes, state.pose);
        if (all)
            all->include(box);
        else
            all = box;
    }
    return all.value_or(AxisBox());
}

ActionFailure SkillSpace::explain(const ProbeOf& probe, const Path& path, const std::string& phase) {
    const auto fast = checker(probe);
    ActionFailure failure = contact_on_path(*fast, path, phase);
    const bool of_hand = fast->problem().robot == hand_.robot;
    if (of_hand) failure.configuration.clear();
    failure.world.reset();
    const std::vector<int> bodies = bodies_of(probe);
    for (Contact& contact : failure.contacts) {
        for (Participant* who : {&contact.first, &contact.second}) {
            if (who->kind == Participant::Kind::body) {
                who->index = bodies[static_cast<std::size_t>(who->index)];
            } else if (of_hand) {
                const auto whole = std::ranges::find(hand_.links, who->index);
                who->index = static_cast<int>(whole - hand_.links.begin());
            }
        }
    }
    return failure;
}

}  // namespace praxis::tamp
