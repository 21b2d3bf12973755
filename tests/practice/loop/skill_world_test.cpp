#include "practice/loop/skill_world.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "practice/loop/practised_skills.hpp"
#include "tests/practice/support/runs.hpp"

namespace praxis::practice {
namespace {

using test::quick;

/// A glass to fill: (take GLASS), then (pour GLASS) with a tilt that must suit how deep the glass is. A
/// state: which glass is held (or -1); of each glass, whether it is full, and how deep it is.
class Pouring : public Environment {
  public:
    Pouring() {
        description_.name = "pouring";
        description_.domain = R"((define (domain pouring) (:requirements :typing) (:types glass)
  (:predicates (held ?g - glass) (full ?g - glass))
  (:action take :parameters (?g - glass) :precondition () :effect (held ?g))
  (:action pour :parameters (?g - glass) :precondition (held ?g) :effect (full ?g))))";
        description_.problem = R"((define (problem p) (:domain pouring) (:objects tumbler goblet - glass)
  (:init) (:goal (full tumbler))))";
        description_.predicates = {"held", "full"};
        description_.objects = {"tumbler", "goblet"};
        description_.schemas = {{"take", {}, {}, {}}, {"pour", {"tilt"}, {"depth"}, {0}}};
        description_.horizon = 4;
        description_.cycle_steps = 20;
    }
    const Description& description() const override { return description_; }
    bool holds(const State& state, const GroundAtom& atom) const override {
        const auto glass = static_cast<std::size_t>(atom.objects[0]);
        return atom.predicate == 0 ? state[0] == atom.objects[0] : state[1 + glass] != 0;
    }
    void propose(const State&, const GroundSkill&, Random& random,
                 std::span<double> parameters) const override {
        if (!parameters.empty()) parameters[0] = uniform(random, 0, 90);
    }
    void features(const State& state, const GroundSkill& skill, std::span<double> features) const override {
        if (!features.empty()) features[0] = state[3 + static_cast<std::size_t>(skill.objects[0])];
    }

  private:
    Description description_;
};

/// A robot that knows names and nothing of practice.
struct Robot : Skills {
    Execution execute(const ActionName& action, std::span<const double> parameters,
                      std::stop_token stop) override {
        ++calls;
        if (stop.stop_requested()) return {Execution::Status::failed, "told to stop"};
        const std::size_t glass = action.words.at(1) == "tumbler" ? 0 : 1;
        if (action.words[0] == "take") {
            EXPECT_TRUE(parameters.empty());
            held = static_cast<double>(glass);
            return {};
        }
        if (held != static_cast<double>(glass)) return {Execution::Status::illegal, "it is not in my hand"};
        EXPECT_EQ(parameters.size(), 1u);
        ++pours;
        full[glass] = std::abs(parameters[0] - 200 * depth[glass]) < 8;
        filled += full[glass];
        return {};
    }
    State see() const { return {held, full[0] ? 1. : 0., full[1] ? 1. : 0., depth[0], depth[1]}; }

    double held = -1;
    std::array<bool, 2> full = {};
    std::array<double, 2> depth = {0.1, 0.3};
    int calls = 0, pours = 0, filled = 0;
};

TEST(SkillWorld, SkillsAreCalledByNameWithTheirParameters) {
    const Pouring pouring;
    Robot robot;
    SkillWorld world(
        pouring.description(), robot, [&] { return robot.see(); },
        [] {
            return std::vector<GroundAtom>{{1, {1}}};
        });
    EXPECT_EQ(world.next_task(), (std::vector<GroundAtom>{{1, {1}}}));
    const GroundSkill pour{1, {1}};
    const std::vector<double> tilt = {59};
    world.execute(pour, tilt);
    EXPECT_EQ(world.last().status, Execution::Status::illegal);
    EXPECT_EQ(world.last().message, "it is not in my hand");
    world.execute({0, {1}}, {});
    EXPECT_EQ(world.observe(), (State{1, 0, 0, 0.1, 0.3}));
    world.execute(pour, tilt);
    EXPECT_EQ(world.last().status, Execution::Status::done);
    EXPECT_EQ(world.observe(), (State{1, 0, 1, 0.1, 0.3}));
}

TEST(SkillWorld, AStopReachesTheSkill) {
    const Pouring pouring;
    Robot robot;
    std::stop_source stop;
    SkillWorld world(
        pouring.description(), robot, [&] { return robot.see(); }, [] { return std::vector<GroundAtom>{}; },
        stop.get_token());
    stop.request_stop();
    world.execute({0, {0}}, {});
    EXPECT_EQ(world.last().status, Execution::Status::failed);
    EXPECT_EQ(robot.held, -1);
}

TEST(SkillWorld, PracticeFindsParametersThatWork) {
    const Pouring pouring;
    Robot robot;
    Random random(3);
    SkillWorld world(
        pouring.description(), robot, [&] { return robot.see(); },
        [&] {
            robot.held = -1;
            robot.full = {};
            for (double& depth : robot.depth) depth = uniform(random, 0.1, 0.3);
            return std::vector<GroundAtom>{{1, {static_cast<std::int32_t>(random.below(2))}}};
        });
    PracticeOptions options = quick();
    options.cycle_steps = 0;
    options.policy.candidates = 50;
    PracticeLoop loop(pouring, world, options);
    const auto share = [&](int cycles) {
        robot.pours = robot.filled = 0;
        for (int cycle = 0; cycle < cycles; ++cycle) EXPECT_TRUE(loop.run_cycle());
        return static_cast<double>(robot.filled) / robot.pours;
    };
    const double first = share(1);
    share(12);
    const double last = share(5);
    EXPECT_EQ(robot.calls, loop.learner().transitions());
    EXPECT_LT(first, 0.4);  // the hit of a guess: 16 of 90 degrees
    EXPECT_GT(last, 0.5);

    // Whoever calls it by name alone now gets what was learned.
    PractisedSkills practised(loop.learner(), robot, [&] { return robot.see(); });
    robot.pours = robot.filled = 0;
    for (int i = 0; i < 50; ++i) {
        for (double& depth : robot.depth) depth = uniform(random, 0.1, 0.3);
        EXPECT_EQ(practised.execute({{"take", "goblet"}}, {}, {}).status, Execution::Status::done);
        EXPECT_EQ(practised.execute({{"pour", "tumbler"}}, {}, {}).status, Execution::Status::illegal);
        EXPECT_EQ(practised.execute({{"pour", "goblet"}}, {}, {}).status, Execution::Status::done);
    }
    EXPECT_GT(robot.filled, 35);
    const std::vector<double> upside_down = {180};
    practised.execute({{"pour", "goblet"}}, upside_down, {});
    EXPECT_FALSE(robot.full[1]);
}

}  // namespace
}  // namespace praxis::practice
