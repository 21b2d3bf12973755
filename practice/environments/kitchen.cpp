#include "practice/environments/kitchen.hpp"

#include <algorithm>
#include <array>

#include "practice/environments/texts.hpp"

namespace praxis::practice {

namespace {

// Objects, in the order of the description.
constexpr std::int32_t kCounter = 0;
constexpr std::int32_t kFloor = 4;
constexpr std::int32_t kPlaces = 5;
constexpr std::int32_t kCup = 5;
constexpr std::int32_t kPlate = 6;
constexpr std::int32_t kBrush = 7;
constexpr std::int32_t kCrumbs = 8;
constexpr std::int32_t kHeaps = 2;
constexpr std::int32_t kObjects = kCrumbs + kHeaps;

// Where a thing or a heap is: a place, or the hand or the bin.
constexpr double kHand = kPlaces;
constexpr double kBin = kPlaces;

constexpr std::array<double, kPlaces> kLevels = {0.1, -0.3, 0.7, -0.6, -1};
/// Weights of the things, coarseness of the crumbs; by object from the cup on.
constexpr std::array<double, kObjects - kCup> kNatures = {-0.4, 0, 0.5, 0.3, -0.4};
constexpr double kDrawerHeight = 0.4;

/// What tasks ask for.
enum Kind : std::size_t { kDish, kBothHeaps, kDishAndHeap, kDishAndBothHeaps };

/// For each object from the cup on, where it is and then how it lies.
enum Number : std::size_t { robot, drawer_open_, stiffness, lamp_on_, first_object, number_count = 14 };

enum Predicate : std::int32_t {
    at,
    hand_empty,
    holding,
    on,
    crumbs_on,
    in_bin,
    drawer_open,
    drawer_closed,
    lamp_on,
    lamp_off
};

enum Schema : std::int32_t {
    go,
    pick,
    place,
    sweep,
    tip_out,
    open_drawer,
    close_drawer,
    switch_lamp_on,
    switch_lamp_off
};

std::size_t offset(std::int32_t object) {
    return first_object + 2 * static_cast<std::size_t>(object - kCup);
}
double& where(State& s, std::int32_t object) {
    return s[offset(object)];
}
double where(const State& s, std::int32_t object) {
    return s[offset(object)];
}
/// The handle of a thing, the spread of a heap.
double& lie(State& s, std::int32_t object) {
    return s[offset(object) + 1];
}
double lie(const State& s, std::int32_t object) {
    return s[offset(object) + 1];
}
double nature(std::int32_t object) {
    return kNatures[static_cast<std::size_t>(object - kCup)];
}
double level(std::int32_t place) {
    return kLevels[static_cast<std::size_t>(place)];
}
double any_lie(Random& random) {
    return uniform(random, -1, 1);
}

bool is_hand_empty(const State& s) {
    return where(s, kCup) != kHand && where(s, kPlate) != kHand && where(s, kBrush) != kHand;
}

Description describe() {
    Description description;
    description.name = "kitchen";
    description.domain = texts::kKitchenDomain;
    description.problem = texts::kKitchenProblem;
    description.predicates = {"at",     "hand-empty",  "holding",       "on",      "crumbs-on",
                              "in-bin", "drawer-open", "drawer-closed", "lamp-on", "lamp-off"};
    description.objects = {"counter", "table", "shelf", "sink",         "floor",
                           "cup",     "plate", "brush", "bread-crumbs", "coffee-grounds"};
    const std::vector<std::string> drawer = {"stiffness", "lamp"};
    const std::vector<std::string> lamp = {"lamp", "stiffness"};
    description.schemas = {
        {"go", {}, {}, {}},
        {"pick", {"grip", "lift"}, {"handle", "weight", "level"}, {0, 1}},
        {"place", {"tilt", "height"}, {"handle", "weight", "level"}, {0, 2}},
        {"sweep", {"direction", "force"}, {"spread", "coarseness", "level"}, {0, 1}},
        {"tip-out", {}, {}, {}},
        {"open-drawer", {"pull", "height"}, drawer, {0}},
        {"close-drawer", {"pull", "height"}, drawer, {0}},
        {"switch-lamp-on", {"force", "angle"}, lamp, {0}},
        {"switch-lamp-off", {"force", "angle"}, lamp, {0}},
    };
    description.horizon = 12;
    description.cycle_steps = 100;
    return description;
}

}  // namespace

Kitchen::Kitchen() : StatedEnvironment(describe(), signatures(), number_count) {}

CheckedEnvironment::Signatures Kitchen::signatures() {
    const Range place{0, kPlaces - 1};
    const Range thing{kCup, kBrush};
    const Range brush{kBrush, kBrush};
    const Range crumbs{kCrumbs, kObjects - 1};
    return {{{place}, {}, {thing}, {thing, place}, {crumbs, place}, {crumbs}, {}, {}, {}, {}},
            {{place, place},
             {thing, place},
             {thing, place},
             {crumbs, brush, place},
             {crumbs, place},
             {place},
             {place},
             {},
             {}}};
}

PracticeTask Kitchen::sample_task(Random& random) const {
    PracticeTask task;
    State& s = task.initial;
    s.assign(number_count, 0);
    s[robot] = static_cast<double>(random.below(kPlaces));
    s[stiffness] = any_lie(random);
    for (std::int32_t object = kCup; object < kObjects; ++object) {
        where(s, object) = static_cast<double>(random.below(kFloor));
        lie(s, object) = any_lie(random);
    }
    const std::size_t kind = random.below(4);
    if (kind != kBothHeaps) {
        const std::int32_t dish = random.below(2) == 0 ? kCup : kPlate;
        const auto step = static_cast<std::int32_t>(1 + random.below(kFloor - 1));
        task.goal.push_back({on, {dish, (static_cast<std::int32_t>(where(s, dish)) + step) % kFloor}});
    }
    if (kind != kDish) {
        const auto heap = static_cast<std::int32_t>(random.below(kHeaps));
        task.goal.push_back({in_bin, {kCrumbs + heap}});
        if (kind != kDishAndHeap) task.goal.push_back({in_bin, {kCrumbs + 1 - heap}});
    }
    return task;
}

bool Kitchen::atom_holds(const State& s, const GroundAtom& atom) const {
    const std::vector<std::int32_t>& objects = atom.objects;
    switch (atom.predicate) {
        case at:
            return s[robot] == objects[0];
        case hand_empty:
            return is_hand_empty(s);
        case holding:
        case in_bin:
            return where(s, objects[0]) == kHand;
        case on:
        case crumbs_on:
            return where(s, objects[0]) == objects[1];
        case drawer_open:
            return s[drawer_open_] != 0;
        case drawer_closed:
            return s[drawer_open_] == 0;
        case lamp_on:
            return s[lamp_on_] != 0;
        default:
            return s[lamp_on_] == 0;
    }
}

bool Kitchen::can_start(const State& s, const GroundSkill& skill) const {
    const std::vector<std::int32_t>& o = skill.objects;
    switch (skill.schema) {
        case go:
            return s[robot] == o[0] && o[0] != o[1];
        case pick:
            return s[robot] == o[1] && where(s, o[0]) == o[1] && is_hand_empty(s);
        case place:
            return s[robot] == o[1] && where(s, o[0]) == kHand;
        case sweep:
            return s[robot] == o[2] && where(s, o[0]) == o[2] && where(s, kBrush) == kHand;
        case tip_out:
            return s[robot] == o[1] && where(s, o[0]) == kBin && is_hand_empty(s);
        case open_drawer:
            return s[robot] == kCounter && o[0] == kCounter && s[drawer_open_] == 0 && is_hand_empty(s);
        case close_drawer:
            return s[robot] == kCounter && o[0] == kCounter && s[drawer_open_] != 0 && is_hand_empty(s);
        case switch_lamp_on:
            return s[lamp_on_] == 0;
        default:
            return s[lamp_on_] != 0;
    }
}

void Kitchen::optimum(const State& s, const GroundSkill& skill, std::span<double> parameters) const {
    switch (skill.schema) {
        case pick:
        case sweep:
            parameters[0] = lie(s, skill.objects[0]);
            parameters[1] = nature(skill.objects[0]);
            return;
        case place:
            parameters[0] = lie(s, skill.objects[0]) / 2;
            parameters[1] = level(skill.objects[1]);
            return;
        case open_drawer:
        case close_drawer:
            parameters[0] = s[stiffness];
            parameters[1] = kDrawerHeight;
            return;
        default:
            std::fill(parameters.begin(), parameters.end(), 0.0);
            return;
    }
}

LogisticSuccess Kitchen::model(const State&, const GroundSkill& skill) const {
    constexpr double kAnyDistance = 1e300;
    switch (skill.schema) {
        case pick:
            return {.tolerance = 0.8};
        case place:
            if (skill.objects[1] == kFloor) return {.tolerance = kAnyDistance, .ceiling = 1};
            return {.tolerance = 0.75};
        case sweep:
            return {.tolerance = 0.7};
        case switch_lamp_on:
        case switch_lamp_off:
            return {.tolerance = kAnyDistance, .ceiling = 0.3};
        default:
            return {.tolerance = 0.6};
    }
}

void Kitchen::succeed(State& s, const GroundSkill& skill, Random& random) const {
    const std::vector<std::int32_t>& o = skill.objects;
    switch (skill.schema) {
        case go:
            s[robot] = o[1];
            return;
        case pick:
            where(s, o[0]) = kHand;
            return;
        case place:
            where(s, o[0]) = o[1];
            lie(s, o[0]) = any_lie(random);
            return;
        case sweep:
            where(s, o[0]) = kBin;
            return;
        case tip_out:
            where(s, o[0]) = o[1];
            lie(s, o[0]) = any_lie(random);
            return;
        case open_drawer:
        case close_drawer:
            s[drawer_open_] = skill.schema == open_drawer ? 1 : 0;
            s[stiffness] = any_lie(random);
            return;
        default:
            s[lamp_on_] = skill.schema == switch_lamp_on ? 1 : 0;
            return;
    }
}

void Kitchen::fail(State& s, const GroundSkill& skill, Random& random) const {
    switch (skill.schema) {
        case place:
            where(s, skill.objects[0]) = kFloor;
            lie(s, skill.objects[0]) = any_lie(random);
            return;
        case pick:
        case sweep:
            lie(s, skill.objects[0]) = any_lie(random);
            return;
        case open_drawer:
        case close_drawer:
            s[stiffness] = any_lie(random);
            return;
        default:
            return;
    }
}

void Kitchen::write_features(const State& s, const GroundSkill& skill, std::span<double> features) const {
    switch (skill.schema) {
        case pick:
        case place:
        case sweep:
            features[0] = lie(s, skill.objects[0]);
            features[1] = nature(skill.objects[0]);
            features[2] = level(skill.objects.back());
            return;
        case open_drawer:
        case close_drawer:
            features[0] = s[stiffness];
            features[1] = s[lamp_on_];
            return;
        default:
            features[0] = s[lamp_on_];
            features[1] = s[stiffness];
            return;
    }
}

}  // namespace praxis::practice
