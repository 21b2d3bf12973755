// Multi-valued variables and sensing models: what is read, what follows, and what actions do to it.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "belief/agent.hpp"
#include "belief/check_run.hpp"
#include "belief/simulated_world.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

std::vector<std::string> readings(const BeliefTask& task, const std::string& action) {
    std::vector<std::string> names;
    for (const GroundReading& reading : task.readings[action_of(task, action)])
        names.push_back(task.physical->fact_name(reading.fact));
    return names;
}

Texts cave(const std::string& body, const std::string& more = "") {
    return propositional(
        "(p) (q) (r) (o) (g)",
        "(:obs-variable w (o))(:action win :parameters () :precondition (p) :effect (g))" + body,
        "(unknown (p)) (unknown (q)) (unknown (r))", "(g)", more);
}

Truth truth(const Belief& belief, const BeliefTask& task, const std::string& atom) {
    return belief.truth(fact_of(task, atom));
}

TEST(SensingModel, AFactAloneIsReadItself) {
    const auto task = ground(cave("(:action look :parameters () :sensing-model (when (p) (o)))"));
    EXPECT_EQ(readings(*task, "(look)"), std::vector<std::string>{"Atom p()"});
    EXPECT_TRUE(task->definitions.empty());
}

TEST(SensingModel, WhatTheActionMakesCertainIsLeftOut) {
    const auto task = ground(
        cave("(:action look :parameters () :effect (r) :sensing-model (when (and (r) (p)) (o)))"
             "(:action miss :parameters () :effect (not (r)) :sensing-model (when (and (r) (p)) (o)))"));
    EXPECT_EQ(readings(*task, "(look)"), std::vector<std::string>{"Atom p()"});
    EXPECT_TRUE(readings(*task, "(miss)").empty());
}

TEST(SensingModel, SeveralCausesAreTiedToWhatIsShown) {
    const auto task = ground(cave("(:action look :parameters () :sensing-model (when (or (p) (q)) (o)))"));
    EXPECT_EQ(readings(*task, "(look)"), std::vector<std::string>{"Atom o()"});
    const Fact shown = fact_of(*task, "(o)");
    Belief none(compile(task));
    ASSERT_TRUE(none.learn({shown.variable, 1 - shown.value}));
    EXPECT_EQ(truth(none, *task, "(p)"), Truth::known_false);
    EXPECT_EQ(truth(none, *task, "(q)"), Truth::known_false);
    Belief some(compile(task));
    ASSERT_TRUE(some.learn(shown));
    EXPECT_EQ(truth(some, *task, "(p)"), Truth::unknown);
    const Fact q = fact_of(*task, "(q)");
    ASSERT_TRUE(some.learn({q.variable, 1 - q.value}));
    EXPECT_EQ(truth(some, *task, "(p)"), Truth::known_true);
}

TEST(SensingModel, ConjunctionsAreTiedToo) {
    const auto task = ground(
        cave("(:action look :parameters () :sensing-model (and (when (and (p) (q)) (o)) (when (r) (o))))"));
    Belief belief(compile(task));
    const Fact r = fact_of(*task, "(r)");
    ASSERT_TRUE(belief.learn(fact_of(*task, "(o)")));
    ASSERT_TRUE(belief.learn({r.variable, 1 - r.value}));
    EXPECT_EQ(truth(belief, *task, "(p)"), Truth::known_true);
    EXPECT_EQ(truth(belief, *task, "(q)"), Truth::known_true);
}

TEST(SensingModel, AModelThatOnlySaysWhatReadsFalse) {
    const auto task =
        ground(cave("(:action look :parameters () :sensing-model (when (or (p) (q)) (not (o))))"));
    Belief belief(compile(task));
    ASSERT_TRUE(belief.learn(fact_of(*task, "(o)")));
    EXPECT_EQ(truth(belief, *task, "(p)"), Truth::known_false);
}

TEST(SensingModel, TheDefaultModelIsThatOfActionsWithoutOne) {
    const auto task =
        ground(cave("(:default-sensing-model (and (when (p) (o)) (r)))"
                    "(:action other :parameters () :sensing-model (when (q) (o)))"));
    EXPECT_EQ(readings(*task, "(win)"), std::vector<std::string>{"Atom r()"});  // (p) is its precondition
    EXPECT_EQ(readings(*task, "(other)"), std::vector<std::string>{"Atom q()"});
}

TEST(SensingModel, ActionsKeepWhatIsShownRight) {
    const auto task =
        ground(cave("(:action look :parameters () :sensing-model (when (or (p) (q)) (o)))"
                    "(:action wipe :parameters () :effect (not (p)))"));
    Belief belief(compile(task));
    ASSERT_TRUE(belief.learn(fact_of(*task, "(o)")));
    belief.act(action_of(*task, "(wipe)"));
    EXPECT_EQ(truth(belief, *task, "(o)"), Truth::unknown);
    ASSERT_TRUE(belief.learn(fact_of(*task, "(o)")));
    EXPECT_EQ(truth(belief, *task, "(q)"), Truth::known_true);
}

TEST(SensingModel, HiddenWorldsShowWhatFollows) {
    const auto task = ground(cave("(:action look :parameters () :sensing-model (when (or (p) (q)) (o)))",
                                  "(:hidden (q)) (:hidden (r))"));
    const Fact shown = fact_of(*task, "(o)");
    const auto variable = static_cast<std::size_t>(shown.variable);
    EXPECT_EQ(hidden_world(*task, 0)[variable], shown.value);
    EXPECT_EQ(hidden_world(*task, 1)[variable], 1 - shown.value);
}

/// A corridor of four cells; the walls are felt.
Texts corridor(const std::string& body, const std::string& goal) {
    return {
        "(define (domain d) (:types cell) (:constants c1 c2 c3 c4 - cell)"
        "(:predicates (at ?c - cell) (next ?c ?d - cell) (wall) (done))"
        "(:variable place (forall (?c - cell) (at ?c)))(:obs-variable w (wall))"
        "(:default-sensing-model (and (when (at c1) (wall)) (when (at c4) (wall))))"
        "(:action feel :parameters ())"
        "(:action right :parameters () :effect (forall (?c ?d - cell) (when (and (at ?c) (next ?c ?d))"
        " (and (not (at ?c)) (at ?d)))))" +
            body + ")",
        "(define (problem p) (:domain d) (:init (next c1 c2) (next c2 c3) (next c3 c4)) (:goal " + goal +
            "))"};
}

void solve_everywhere(const std::shared_ptr<const BeliefTask>& task) {
    const auto compilation = compile(task);
    const Agent agent(std::make_shared<const KnowledgePlanner>(compilation));
    const auto worlds = enumerate_worlds(*task, 100);
    ASSERT_TRUE(worlds && !worlds->empty());
    for (const WorldState& first : *worlds) {
        Belief belief(compilation);
        SimulatedWorld world(task, first);
        const RunResult run = agent.run(belief, world);
        EXPECT_EQ(run.status, RunStatus::reached);
        const Verdict verdict = check_run(*task, first, run.actions, world.after_chance());
        EXPECT_TRUE(verdict.valid) << verdict.reason;
    }
}

TEST(SensingModel, ARobotFindsItself) {
    solve_everywhere(ground(corridor("", "(at c4)")));
}

TEST(SensingModel, ObservableAtomsInConditions) {
    const auto task = ground(corridor(
        "(:action stop :parameters () :precondition (and (wall) (not (at c1))) :effect (done))", "(done)"));
    EXPECT_EQ(task->definitions.size(), 1u);
    solve_everywhere(task);
}

TEST(SensingModel, ARobotThatIsCarriedAwayFindsItselfAgain) {
    const auto task = ground(corridor(
        "(:action carry :parameters () :precondition (at c2) :effect (and (unknown (at c1)) (done)))",
        "(and (done) (at c3))"));
    ASSERT_EQ(task->choices.size(), 1u);
    EXPECT_EQ(task->choices[0].size(), 4u);
    Belief belief(compile(task));
    const auto at = [&](const char* cell) { return fact_of(*task, cell); };
    ASSERT_TRUE(belief.learn(at("(at c2)")));
    EXPECT_EQ(truth(belief, *task, "(at c1)"), Truth::known_false);
    belief.act(action_of(*task, "(carry)"));
    for (const char* cell : {"(at c1)", "(at c2)", "(at c3)", "(at c4)", "(wall)"})
        EXPECT_EQ(truth(belief, *task, cell), Truth::unknown) << cell;
    const Fact wall = fact_of(*task, "(wall)");
    ASSERT_TRUE(belief.learn({wall.variable, 1 - wall.value}));
    EXPECT_EQ(truth(belief, *task, "(at c4)"), Truth::known_false);
    const Fact second = at("(at c2)");
    ASSERT_TRUE(belief.learn({second.variable, 1 - second.value}));
    EXPECT_EQ(truth(belief, *task, "(at c3)"), Truth::known_true);
    EXPECT_FALSE(belief.learn(wall));
}

TEST(SensingModel, TheWorldDrawsOneValue) {
    const auto task = ground(corridor("(:action carry :parameters () :effect (unknown (at c1)))", "(at c3)"));
    SimulatedWorld world(task, enumerate_worlds(*task, 100)->front(), 0, 7);
    const Fact wall = fact_of(*task, "(wall)");
    std::set<std::size_t> seen;
    for (int i = 0; i < 50; ++i) {
        ASSERT_EQ(world.execute(action_of(*task, "(carry)")).status, Execution::Status::done);
        std::size_t holding = 0, cell = 0;
        for (std::size_t c = 0; c < 4; ++c) {
            const Fact at = fact_of(*task, "(at c" + std::to_string(c + 1) + ")");
            if (world.state()[static_cast<std::size_t>(at.variable)] != at.value) continue;
            ++holding;
            cell = c;
        }
        ASSERT_EQ(holding, 1u);
        EXPECT_EQ(world.state()[static_cast<std::size_t>(wall.variable)] == wall.value,
                  cell == 0 || cell == 3);
        seen.insert(cell);
    }
    EXPECT_EQ(seen.size(), 4u);
}

TEST(Observable, AtomsAreReadAtAnyTime) {
    const auto task = ground(cave("(:observable (q))"));
    ASSERT_EQ(task->sensors.size(), 1u);
    EXPECT_EQ(task->sensors[0].reading.fact.variable, fact_of(*task, "(q)").variable);
    SimulatedWorld world(task, enumerate_worlds(*task, 100)->front());
    EXPECT_EQ(world.observe(Environment::kStart).size(), 1u);
}

TEST(MultiValued, AValueThatIsFalseLeavesTheOthersOpen) {
    const auto task =
        ground({"(define (domain d) (:predicates (x) (y) (z) (g)) (:variable v (x) (y) (z))"
                "(:action win :parameters () :precondition (z) :effect (g))"
                "(:action look :parameters () :sensing-model (y)))",
                "(define (problem p) (:domain d) (:init (not (x))) (:goal (g)))"});
    Belief belief(compile(task));
    EXPECT_EQ(truth(belief, *task, "(z)"), Truth::unknown);
    const Fact y = fact_of(*task, "(y)");
    ASSERT_TRUE(belief.learn({y.variable, 1 - y.value}));
    EXPECT_EQ(truth(belief, *task, "(z)"), Truth::known_true);
}

}  // namespace
}  // namespace praxis::belief::test
