#include "practice/environments/light_switch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "practice/environments/texts.hpp"

namespace praxis::practice {

namespace {

constexpr double kTolerance = 0.1;

enum Number : std::size_t { cell, level, target, number_count };
enum Predicate : std::int32_t { robot_in, light_on, light_off };
enum Schema : std::int32_t { move, turn_on, turn_off, jump_to_light };

bool is_on(const State& state) {
    return std::abs(state[level] - state[target]) < kTolerance;
}

std::string problem_text(int cells) {
    std::string objects;
    std::string adjacent;
    for (int i = 0; i < cells; ++i) {
        const std::string name = "c" + std::to_string(i);
        objects += name + ' ';
        if (i == 0) continue;
        const std::string before = "c" + std::to_string(i - 1);
        adjacent += "\n    (adjacent " + before + ' ' + name + ") (adjacent " + name + ' ' + before + ')';
    }
    return "(define (problem light-switch-" + std::to_string(cells) +
           ")\n  (:domain light-switch)\n  (:objects " + objects +
           "- cell)\n  (:init (robot-in c0) (light-off) (light-in c" + std::to_string(cells - 1) + ')' +
           adjacent + ")\n  (:goal (light-on)))\n";
}

Description describe(int cells) {
    if (cells < 3 || cells > 10000)
        throw std::invalid_argument("light-switch takes 3 to 10000 cells, not " + std::to_string(cells));
    Description description;
    description.name = "light-switch";
    description.domain = texts::kLightSwitchDomain;
    description.problem = problem_text(cells);
    description.predicates = {"robot-in", "light-on", "light-off"};
    for (int i = 0; i < cells; ++i) description.objects.push_back("c" + std::to_string(i));
    const std::vector<std::string> features = {"cell", "level", "target"};
    description.schemas = {{"move", {}, {}, {}},
                           {"turn-on", {"d"}, features, {level, target}},
                           {"turn-off", {"d"}, features, {level, target}},
                           {"jump-to-light", {"d"}, features, {cell}}};
    description.horizon = cells + 2;
    description.cycle_steps = 150;
    return description;
}

}  // namespace

LightSwitch::LightSwitch(int cells)
    : CheckedEnvironment(describe(cells), signatures(cells - 1), number_count), last_cell_(cells - 1) {}

CheckedEnvironment::Signatures LightSwitch::signatures(std::int32_t last_cell) {
    const Range any{0, last_cell};
    return {{{any}, {}, {}}, {{any, any}, {any}, {any}, {any, any, any}}};
}

PracticeTask LightSwitch::sample_task(Random& random) const {
    return {{0, 0, uniform(random, 0.5, 1)}, {{light_on, {}}}};
}

bool LightSwitch::atom_holds(const State& state, const GroundAtom& atom) const {
    switch (atom.predicate) {
        case robot_in:
            return state[cell] == atom.objects[0];
        case light_on:
            return is_on(state);
        default:
            return !is_on(state);
    }
}

bool LightSwitch::can_start(const State& state, const GroundSkill& skill) const {
    const std::vector<std::int32_t>& cells = skill.objects;
    if (state[cell] != cells[0]) return false;
    switch (skill.schema) {
        case move:
            return std::abs(cells[0] - cells[1]) == 1;
        case turn_on:
            return cells[0] == last_cell_ && !is_on(state);
        case turn_off:
            return cells[0] == last_cell_ && is_on(state);
        default:
            return cells[0] == last_cell_ - 2 && cells[1] == last_cell_ - 1 && cells[2] == last_cell_;
    }
}

void LightSwitch::act(State& state, const GroundSkill& skill, std::span<const double> parameters,
                      Random&) const {
    if (skill.schema == move) state[cell] = skill.objects[1];
    if (skill.schema == turn_on || skill.schema == turn_off)
        state[level] = std::clamp(state[level] + parameters[0], 0.0, 1.0);
}

void LightSwitch::draw_parameters(const State&, const GroundSkill&, Random& random,
                                  std::span<double> parameters) const {
    parameters[0] = uniform(random, -1, 1);
}

void LightSwitch::write_features(const State& state, const GroundSkill&, std::span<double> features) const {
    std::copy(state.begin(), state.end(), features.begin());
}

}  // namespace praxis::practice
