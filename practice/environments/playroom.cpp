#include "practice/environments/playroom.hpp"

#include <array>

#include "practice/environments/texts.hpp"

namespace praxis::practice {

namespace {

// Objects, in the order of the description.
constexpr std::int32_t kShelf = 0;
constexpr std::int32_t kTable = 1;
constexpr std::int32_t kCloset = 2;
constexpr std::int32_t kCorner = 3;
constexpr std::int32_t kPlaces = 4;
constexpr std::int32_t kCar = 4;
constexpr std::int32_t kDuck = 5;
constexpr std::int32_t kBin = 6;
constexpr std::int32_t kSweeper = 7;

// Where a movable thing is, if not at a place.
constexpr double kHand = kPlaces;
constexpr double kInBin = kPlaces + 1;

constexpr std::array<double, 2> kWeights = {0.3, -0.4};
constexpr double kClosetHeight = 0.3;
constexpr double kChairPull = 0.5;
constexpr double kDumpHeight = -0.2;
constexpr double kRollsAway = 0.3;

enum Number : std::size_t {
    robot,
    first_where,                    // of car, duck, bin and sweeper
    first_angle = first_where + 4,  // of car and duck
    spread = first_angle + 2,
    closet_is_open,
    stiffness,
    chair_is_away,
    chair_angle,
    number_count
};

enum Predicate : std::int32_t {
    at,
    hand_empty,
    holding,
    on,
    in_bin,
    closet_open,
    closet_closed,
    chair_in_corner,
    chair_away
};

enum Schema : std::int32_t {
    go,
    pick_toy,
    put_toy,
    pick_bin,
    put_bin,
    open_closet,
    close_closet,
    take_sweeper,
    put_sweeper_back,
    pull_chair_away,
    push_chair_back,
    sweep,
    dump
};

double& where(State& s, std::int32_t thing) {
    return s[first_where + static_cast<std::size_t>(thing - kCar)];
}
double where(const State& s, std::int32_t thing) {
    return s[first_where + static_cast<std::size_t>(thing - kCar)];
}
double& angle(State& s, std::int32_t toy) {
    return s[first_angle + static_cast<std::size_t>(toy - kCar)];
}
double angle(const State& s, std::int32_t toy) {
    return s[first_angle + static_cast<std::size_t>(toy - kCar)];
}
double weight(std::int32_t toy) {
    return kWeights[static_cast<std::size_t>(toy - kCar)];
}
double anything(Random& random) {
    return uniform(random, -1, 1);
}

bool is_hand_empty(const State& s) {
    for (std::int32_t thing = kCar; thing <= kSweeper; ++thing)
        if (where(s, thing) == kHand) return false;
    return true;
}
bool both_toys(const State& s, double place) {
    return where(s, kCar) == place && where(s, kDuck) == place;
}
void turn_toys(State& s, Random& random) {
    angle(s, kCar) = anything(random);
    angle(s, kDuck) = anything(random);
    s[spread] = anything(random);
}

Description describe() {
    Description description;
    description.name = "playroom";
    description.domain = texts::kPlayroomDomain;
    description.problem = texts::kPlayroomProblem;
    description.predicates = {"at",          "hand-empty",    "holding",         "on",        "in-bin",
                              "closet-open", "closet-closed", "chair-in-corner", "chair-away"};
    description.objects = {"shelf", "table", "closet", "corner", "car", "duck", "bin", "sweeper"};
    description.schemas = {
        {"go", {}, {}, {}},
        {"pick-toy", {"grip", "lift"}, {"angle", "weight", "spread"}, {0, 1}},
        {"put-toy", {}, {}, {}},
        {"pick-bin", {}, {}, {}},
        {"put-bin", {}, {}, {}},
        {"open-closet", {"pull", "height"}, {"stiffness", "chair-angle"}, {0}},
        {"close-closet", {}, {}, {}},
        {"take-sweeper", {}, {}, {}},
        {"put-sweeper-back", {}, {}, {}},
        {"pull-chair-away", {"grip", "pull"}, {"chair-angle", "stiffness"}, {0}},
        {"push-chair-back", {}, {}, {}},
        {"sweep", {"direction", "force"}, {"angle-1", "angle-2", "spread", "chair-angle"}, {0, 1, 2}},
        {"dump", {"tilt", "height"}, {"spread", "angle-1", "angle-2"}, {0}},
    };
    description.horizon = 24;
    description.cycle_steps = 120;
    return description;
}

}  // namespace

Playroom::Playroom() : StatedEnvironment(describe(), signatures(), number_count) {}

CheckedEnvironment::Signatures Playroom::signatures() {
    const Range place{0, kPlaces - 1};
    const Range toy{kCar, kDuck};
    const Range bin{kBin, kBin};
    const Range sweeper{kSweeper, kSweeper};
    const Range movable{kCar, kSweeper};
    return {{{place}, {}, {movable}, {movable, place}, {toy}, {}, {}, {}, {}},
            {{place, place},
             {toy, place},
             {toy, place},
             {bin, place},
             {bin, place},
             {place},
             {place},
             {sweeper, place},
             {sweeper, place},
             {place},
             {place},
             {toy, toy, sweeper, bin, place},
             {toy, toy, bin, place}}};
}

PracticeTask Playroom::sample_task(Random& random) const {
    State s(number_count, 0);
    s[robot] = static_cast<double>(random.below(kPlaces));
    for (const std::int32_t toy : {kCar, kDuck})
        where(s, toy) = random.below(2) == 0 ? kCorner : static_cast<double>(random.below(kCorner));
    where(s, kBin) = random.below(2) == 0 ? kShelf : kTable;
    where(s, kSweeper) = kCloset;
    turn_toys(s, random);
    s[stiffness] = anything(random);
    s[chair_angle] = anything(random);
    return {s, {{in_bin, {kCar}}, {in_bin, {kDuck}}}};
}

bool Playroom::atom_holds(const State& s, const GroundAtom& atom) const {
    const std::vector<std::int32_t>& objects = atom.objects;
    switch (atom.predicate) {
        case at:
            return s[robot] == objects[0];
        case hand_empty:
            return is_hand_empty(s);
        case holding:
            return where(s, objects[0]) == kHand;
        case on:
            return where(s, objects[0]) == objects[1];
        case in_bin:
            return where(s, objects[0]) == kInBin;
        case closet_open:
            return s[closet_is_open] != 0;
        case closet_closed:
            return s[closet_is_open] == 0;
        case chair_in_corner:
            return s[chair_is_away] == 0;
        default:
            return s[chair_is_away] != 0;
    }
}

bool Playroom::can_start(const State& s, const GroundSkill& skill) const {
    const std::vector<std::int32_t>& o = skill.objects;
    if (skill.schema == go) return s[robot] == o[0] && o[0] != o[1];
    if (s[robot] != o.back()) return false;
    const bool in_closet = s[robot] == kCloset;
    const bool in_corner = s[robot] == kCorner;
    const bool toys_in_order = in_corner && o[0] == kCar && o.size() > 1 && o[1] == kDuck;
    switch (skill.schema) {
        case pick_toy:
        case pick_bin:
            return where(s, o[0]) == o[1] && is_hand_empty(s);
        case put_toy:
        case put_bin:
            return where(s, o[0]) == kHand;
        case open_closet:
            return in_closet && s[closet_is_open] == 0 && is_hand_empty(s);
        case close_closet:
            return in_closet && s[closet_is_open] != 0 && is_hand_empty(s);
        case take_sweeper:
            return where(s, kSweeper) == o[1] && s[closet_is_open] != 0 && is_hand_empty(s);
        case put_sweeper_back:
            return in_closet && where(s, kSweeper) == kHand && s[closet_is_open] != 0;
        case pull_chair_away:
            return in_corner && s[chair_is_away] == 0 && is_hand_empty(s);
        case push_chair_back:
            return in_corner && s[chair_is_away] != 0 && is_hand_empty(s);
        case sweep:
            return toys_in_order && s[chair_is_away] != 0 && where(s, kSweeper) == kHand &&
                   where(s, kBin) == kCorner && both_toys(s, kCorner);
        default:
            return toys_in_order && where(s, kBin) == kHand && both_toys(s, kInBin);
    }
}

void Playroom::optimum(const State& s, const GroundSkill& skill, std::span<double> parameters) const {
    switch (skill.schema) {
        case pick_toy:
            parameters[0] = angle(s, skill.objects[0]);
            parameters[1] = weight(skill.objects[0]);
            return;
        case open_closet:
            parameters[0] = s[stiffness];
            parameters[1] = kClosetHeight;
            return;
        case pull_chair_away:
            parameters[0] = s[chair_angle];
            parameters[1] = kChairPull;
            return;
        case sweep:
            parameters[0] = (angle(s, kCar) + angle(s, kDuck)) / 2;
            parameters[1] = s[spread] / 2;
            return;
        case dump:
            parameters[0] = s[spread] / 2;
            parameters[1] = kDumpHeight;
            return;
        default:
            return;
    }
}

LogisticSuccess Playroom::model(const State&, const GroundSkill& skill) const {
    switch (skill.schema) {
        case pick_toy:
            return {.tolerance = 0.9};
        case sweep:
            return {.tolerance = 0.3};
        default:
            return {.tolerance = 0.8};
    }
}

void Playroom::succeed(State& s, const GroundSkill& skill, Random& random) const {
    const std::vector<std::int32_t>& o = skill.objects;
    switch (skill.schema) {
        case go:
            s[robot] = o[1];
            return;
        case pick_toy:
        case pick_bin:
        case take_sweeper:
            where(s, o[0]) = kHand;
            return;
        case put_toy:
            where(s, o[0]) = o[1];
            angle(s, o[0]) = anything(random);
            s[spread] = anything(random);
            return;
        case put_bin:
        case put_sweeper_back:
            where(s, o[0]) = o[1];
            return;
        case open_closet:
        case close_closet:
            s[closet_is_open] = skill.schema == open_closet ? 1 : 0;
            s[stiffness] = anything(random);
            return;
        case pull_chair_away:
        case push_chair_back:
            s[chair_is_away] = skill.schema == pull_chair_away ? 1 : 0;
            s[chair_angle] = anything(random);
            return;
        default:
            where(s, kCar) = where(s, kDuck) = skill.schema == sweep ? kInBin : kCorner;
            turn_toys(s, random);
            return;
    }
}

void Playroom::fail(State& s, const GroundSkill& skill, Random& random) const {
    switch (skill.schema) {
        case pick_toy:
            angle(s, skill.objects[0]) = anything(random);
            return;
        case open_closet:
            s[stiffness] = anything(random);
            return;
        case pull_chair_away:
            s[chair_angle] = anything(random);
            return;
        case sweep:
            if (uniform(random) < kRollsAway) where(s, random.below(2) == 0 ? kCar : kDuck) = kTable;
            turn_toys(s, random);
            return;
        default:
            turn_toys(s, random);
            return;
    }
}

void Playroom::write_features(const State& s, const GroundSkill& skill, std::span<double> features) const {
    const auto write = [&](auto... values) {
        std::size_t i = 0;
        ((features[i++] = values), ...);
    };
    switch (skill.schema) {
        case pick_toy:
            return write(angle(s, skill.objects[0]), weight(skill.objects[0]), s[spread]);
        case open_closet:
            return write(s[stiffness], s[chair_angle]);
        case pull_chair_away:
            return write(s[chair_angle], s[stiffness]);
        case sweep:
            return write(angle(s, kCar), angle(s, kDuck), s[spread], s[chair_angle]);
        default:
            return write(s[spread], angle(s, kCar), angle(s, kDuck));
    }
}

}  // namespace praxis::practice
