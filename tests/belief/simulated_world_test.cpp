// The simulated world: what it does, what it answers, how it lies.
#include "belief/simulated_world.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

const Texts kTexts = propositional(
    "(p) (q) (g)",
    "(:action look :parameters () :observe (p)) (:action weak :parameters () :observe (probabilistic 0.7 "
    "(p)))"
    "(:action set :parameters () :precondition (not (p)) :effect (p))"
    "(:action move :parameters () :precondition (p) :effect (and (when (q) (g)) (not (p)) (q)) :observe (p))"
    "(:sensor bell :parameters () :condition (q) :sense (p))",
    "(unknown (p)) (unknown (q))", "(g)");

class World {
  public:
    World(bool p, bool q, double noise = 0, std::uint64_t seed = 0)
        : task_(ground(kTexts)), world_(task_, state(p, q), noise, seed) {}

    bool holds(const std::string& atom) const {
        const Fact fact = fact_of(*task_, atom);
        return world_.state()[static_cast<std::size_t>(fact.variable)] == fact.value;
    }
    Execution::Status act(const std::string& name) { return world_.execute(action_of(*task_, name)).status; }
    std::vector<Answer> read(const std::string& name) { return world_.observe(action_of(*task_, name)); }
    bool right(const Answer& answer) const {
        return world_.state()[static_cast<std::size_t>(answer.fact.variable)] == answer.fact.value;
    }
    SimulatedWorld& operator*() { return world_; }

  private:
    WorldState state(bool p, bool q) const {
        WorldState result = task_->initial_values;
        for (const auto& [atom, holds] : {std::pair{"(p)", p}, std::pair{"(q)", q}}) {
            const Fact fact = fact_of(*task_, atom);
            result[static_cast<std::size_t>(fact.variable)] = holds ? fact.value : 1 - fact.value;
        }
        return result;
    }

    std::shared_ptr<const BeliefTask> task_;
    SimulatedWorld world_;
};

TEST(SimulatedWorld, EffectsReadTheStateBefore) {
    World world(true, false);
    EXPECT_EQ(world.act("(move)"), Execution::Status::done);
    EXPECT_FALSE(world.holds("(p)"));
    EXPECT_TRUE(world.holds("(q)"));
    EXPECT_FALSE(world.holds("(g)"));
    EXPECT_FALSE((*world).goal_holds());
    EXPECT_EQ(world.act("(set)"), Execution::Status::done);
    EXPECT_EQ(world.act("(move)"), Execution::Status::done);
    EXPECT_TRUE((*world).goal_holds());
}

TEST(SimulatedWorld, IllegalActionsChangeNothing) {
    World world(false, true);
    const WorldState before = (*world).state();
    EXPECT_EQ(world.act("(move)"), Execution::Status::illegal);
    EXPECT_EQ((*world).state(), before);
}

TEST(SimulatedWorld, AnswersOfActionsAndSensors) {
    World silent(true, false), ringing(true, true);
    EXPECT_EQ((*silent).observe(Environment::kStart).size(), 0u);
    EXPECT_EQ((*ringing).observe(Environment::kStart).size(), 1u);
    EXPECT_EQ(silent.read("(look)").size(), 1u);
    EXPECT_EQ(ringing.read("(look)").size(), 2u);
    EXPECT_EQ(silent.read("(set)").size(), 0u);
    for (const Answer& answer : ringing.read("(look)")) {
        EXPECT_TRUE(ringing.right(answer));
        EXPECT_DOUBLE_EQ(answer.accuracy, 1);
    }
}

/// The share of wrong answers among many.
double errors(World& world, const std::string& action) {
    constexpr int kReadings = 4000;
    int wrong = 0;
    for (int i = 0; i < kReadings; ++i)
        for (const Answer& answer : world.read(action)) wrong += !world.right(answer);
    return static_cast<double>(wrong) / kReadings;
}

TEST(SimulatedWorld, LiesAsOftenAsItSays) {
    for (const double noise : {0.0, 0.1, 0.3, 0.5}) {
        World world(true, false, noise, 7);
        EXPECT_NEAR(errors(world, "(look)"), noise, 0.03) << noise;
        EXPECT_DOUBLE_EQ(world.read("(look)").front().accuracy, 1 - noise);
        // Two errors that cancel each other are none.
        const double both = noise * 0.7 + (1 - noise) * 0.3;
        EXPECT_NEAR(errors(world, "(weak)"), both, 0.03) << noise;
        EXPECT_NEAR(world.read("(weak)").front().accuracy, 1 - both, 1e-9);
    }
}

TEST(SimulatedWorld, TheSameSeedLiesTheSame) {
    World one(true, true, 0.4, 5), same(true, true, 0.4, 5), other(true, true, 0.4, 6);
    bool different = false;
    for (int i = 0; i < 50; ++i) {
        const auto answers = one.read("(look)");
        const auto again = same.read("(look)");
        const auto others = other.read("(look)");
        ASSERT_EQ(answers.size(), again.size());
        for (std::size_t a = 0; a < answers.size(); ++a) EXPECT_EQ(answers[a].fact, again[a].fact);
        different = different || answers.front().fact != others.front().fact;
    }
    EXPECT_TRUE(different);
}

TEST(SimulatedWorld, NoiseOutOfRangeIsRefused) {
    for (const double noise : {-0.01, 0.51, 1.0, std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()})
        EXPECT_THROW(World(true, true, noise), std::invalid_argument) << noise;
}

TEST(SimulatedWorld, WhatIsLeftOpenFallsEitherWay) {
    const auto task = ground(propositional("(p) (g)",
                                           "(:action toss :parameters () :effect (unknown (p)))"
                                           "(:action win :parameters () :precondition (p) :effect (g))",
                                           "", "(g)"));
    SimulatedWorld world(task, task->initial_values, 0, 1);
    const Fact heads = fact_of(*task, "(p)");
    int count = 0;
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(world.execute(action_of(*task, "(toss)")).status, Execution::Status::done);
        count += world.state()[static_cast<std::size_t>(heads.variable)] == heads.value;
    }
    EXPECT_NEAR(count, 500, 80);
}

}  // namespace
}  // namespace praxis::belief::test
