#include "weighing.hpp"

#include <algorithm>
#include <belief/atom_names.hpp>
#include <cmath>

namespace weighing {

namespace belief = praxis::belief;
namespace practice = praxis::practice;
using practice::GroundAtom, practice::GroundSkill, practice::State, practice::uniform;

namespace {

// Objects in the order of the description; then the hand, as a place of boxes.
constexpr std::int32_t kBin = 2, kFirstCupboard = 3, kFirstBox = 6, kHand = 8;
constexpr std::size_t kCupboards = 3;
enum Predicate : std::int32_t { at, on, holding, hand_empty, free_scale, weighed_right, open };
enum Schema : std::int32_t {
    go,
    take_from_table,
    take_from_scale,
    take_from_bin,
    put_on_table,
    put_on_scale,
    drop,
    read_display,
    open_cupboard,
    close_cupboard
};
// Numbers of a state: the robot's place; whether each cupboard is open, and how stiff it is; of each box:
enum BoxNumber : std::size_t { place, weighed, height, box_numbers };
constexpr std::size_t robot = 0, cupboards = 1, boxes = cupboards + 2 * kCupboards;
constexpr std::size_t kNumbers = boxes + kBoxes * box_numbers;

constexpr double kSlip = 0.05;  // that a box slips when it is taken
constexpr double kMost = 10;    // seconds, newtons

double& of(State& state, std::size_t box, BoxNumber number) {
    return state[boxes + box_numbers * box + number];
}
double of(const State& state, std::size_t box, BoxNumber number) {
    return state[boxes + box_numbers * box + number];
}
std::size_t box(std::int32_t object) {
    return static_cast<std::size_t>(object - kFirstBox);
}
bool some_box(const State& state, std::int32_t where) {
    for (std::size_t b = 0; b < kBoxes; ++b)
        if (of(state, b, place) == where) return true;
    return false;
}

double& is_open(State& state, std::int32_t object) {
    return state[cupboards + 2 * static_cast<std::size_t>(object - kFirstCupboard)];
}
bool is_open(const State& state, std::int32_t object) {
    return state[cupboards + 2 * static_cast<std::size_t>(object - kFirstCupboard)] != 0;
}
double stiffness(const State& state, std::int32_t object) {
    return state[cupboards + 2 * static_cast<std::size_t>(object - kFirstCupboard) + 1];
}

/// Half, and nearly one within a second (or newton) of the best.
double chance(double parameter, double feature) {
    const double off = parameter - (2 + 6 * feature);
    return 0.5 + 0.48 * std::exp(-off * off / 2);
}

}  // namespace

double chance_of_right_reading(double wait, double box_height) {
    return chance(wait, box_height);
}

Rehearsal::Rehearsal(std::string domain, std::string problem) {
    description_.name = "weighing";
    description_.domain = std::move(domain);
    description_.problem = std::move(problem);
    description_.predicates = {"at", "on", "holding", "hand-empty", "free", "weighed", "open"};
    description_.objects = {"desk", "balance", "bin", "shelf", "locker", "chest", "box1", "box2"};
    description_.schemas = {{"go", {}, {}, {}},
                            {"take-from-table", {}, {}, {}},
                            {"take-from-scale", {}, {}, {}},
                            {"take-from-bin", {}, {}, {}},
                            {"put-on-table", {}, {}, {}},
                            {"put-on-scale", {}, {}, {}},
                            {"drop", {}, {}, {}},
                            {"read-display", {"wait"}, {"height"}, {0}},
                            {"open-cupboard", {"pull"}, {"stiffness"}, {0}},
                            {"close-cupboard", {}, {}, {}}};
    description_.horizon = 24;
    description_.cycle_steps = 50;
}

bool Rehearsal::holds(const State& s, const GroundAtom& atom) const {
    const std::vector<std::int32_t>& o = atom.objects;
    switch (atom.predicate) {
        case at:
            return s[robot] == o[0];
        case on:
            return of(s, box(o[0]), place) == o[1];
        case holding:
            return of(s, box(o[0]), place) == kHand;
        case hand_empty:
            return !some_box(s, kHand);
        case free_scale:
            return !some_box(s, o[0]);
        case weighed_right:
            return of(s, box(o[0]), weighed) != 0;
        default:
            return is_open(s, o[0]);
    }
}

bool Rehearsal::can_start(const State& s, const GroundSkill& skill) const {
    const std::vector<std::int32_t>& o = skill.objects;
    switch (skill.schema) {
        case go:
            return s[robot] == o[0] && o[0] != o[1];
        case take_from_table:
        case take_from_scale:
        case take_from_bin:
            return s[robot] == o[1] && of(s, box(o[0]), place) == o[1] && !some_box(s, kHand);
        case put_on_table:
            return s[robot] == o[1] && of(s, box(o[0]), place) == kHand;
        case put_on_scale:
            return s[robot] == o[1] && of(s, box(o[0]), place) == kHand && !some_box(s, o[1]);
        case drop:
            return s[robot] == o[1] && of(s, box(o[0]), place) == kHand && of(s, box(o[0]), weighed) != 0;
        case read_display:
            return s[robot] == o[1] && of(s, box(o[0]), place) == o[1];
        default:
            return s[robot] == o[0] && !some_box(s, kHand) &&
                   is_open(s, o[0]) == (skill.schema == close_cupboard);
    }
}

void Rehearsal::propose(const State&, const GroundSkill&, praxis::Random& random,
                        std::span<double> parameters) const {
    for (double& parameter : parameters) parameter = uniform(random, 0, kMost);
}

void Rehearsal::features(const State& s, const GroundSkill& skill, std::span<double> features) const {
    if (skill.schema == read_display) features[0] = of(s, box(skill.objects[0]), height);
    if (skill.schema == open_cupboard) features[0] = stiffness(s, skill.objects[0]);
}

practice::PracticeTask Rehearsal::sample_task(praxis::Random& random) const {
    practice::PracticeTask task{State(kNumbers), {}};
    for (std::size_t c = 0; c < kCupboards; ++c) task.initial[cupboards + 2 * c + 1] = uniform(random);
    for (std::size_t b = 0; b < kBoxes; ++b) {
        of(task.initial, b, height) = uniform(random);
        const auto object = static_cast<std::int32_t>(kFirstBox + b);
        const bool heavy = random.below(2) == 0;
        task.goal.push_back(heavy ? GroundAtom{weighed_right, {object}} : GroundAtom{on, {object, kBin}});
    }
    return task;
}

void Rehearsal::execute(State& s, const GroundSkill& skill, std::span<const double> parameters,
                        praxis::Random& random) const {
    if (!can_start(s, skill)) return;
    const std::vector<std::int32_t>& o = skill.objects;
    switch (skill.schema) {
        case go:
            s[robot] = o[1];
            break;
        case take_from_table:
        case take_from_scale:
        case take_from_bin:
            if (uniform(random) >= kSlip) of(s, box(o[0]), place) = kHand;
            break;
        case put_on_table:
        case put_on_scale:
        case drop:
            of(s, box(o[0]), place) = o[1];
            break;
        case read_display:
            of(s, box(o[0]), weighed) = uniform(random) < chance(parameters[0], of(s, box(o[0]), height));
            break;
        case open_cupboard:
            is_open(s, o[0]) = uniform(random) < chance(parameters[0], stiffness(s, o[0]));
            break;
        default:
            is_open(s, o[0]) = 0;
    }
}

State Rehearsal::with_box(std::size_t box, double box_height) {
    State state(kNumbers);
    of(state, box, height) = box_height;
    return state;
}

Robot::Robot(std::shared_ptr<const belief::BeliefTask> task, belief::WorldState state, const Look& look,
             std::uint64_t seed)
    : task_(std::move(task)), world_(task_, std::move(state)), look_(&look), random_(seed) {
    for (double& box_height : heights_) box_height = uniform(random_);
}

belief::Execution Robot::execute(std::uint32_t action, std::stop_token stop) {
    if (world_.applicable(action) &&
        belief::AtomNames::name(*task_->physical, action).words[0].starts_with("take-") &&
        uniform(random_) < kSlip)
        return {belief::Execution::Status::failed, "the box slips"};
    return world_.execute(action, stop);
}

/// Only `read-display` tells anything in this domain.
std::vector<belief::Answer> Robot::observe(std::uint32_t action, std::stop_token stop) {
    std::vector<belief::Answer> answers = world_.observe(action, stop);
    for (belief::Answer& answer : answers) {
        ++readings_;
        const std::string name = belief::AtomNames::name(*task_->physical, action).words[1];
        const std::size_t box = name == "box1" ? 0 : 1;
        const double wait = look_->wait(box, heights_[box], random_);
        const bool right = uniform(random_) < chance(wait, heights_[box]);
        right_ += right;
        if (!right) answer.fact.value = 1 - answer.fact.value;
        answer.accuracy = look_->accuracy[box];
    }
    return answers;
}

}  // namespace weighing
