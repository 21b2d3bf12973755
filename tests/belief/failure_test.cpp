// Actions that fail: what is known then, and how the loop finds out what has happened.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>

#include "belief/agent.hpp"
#include "belief/check_run.hpp"
#include "belief/robot_environment.hpp"
#include "belief/simulated_world.hpp"
#include "parser/diagnostic.hpp"
#include "tests/belief/random_contingent.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

/// A ball is carried from a to b; nothing is uncertain.
Texts carrying(const std::string& more = "") {
    return {
        "(define (domain carry) (:types place) (:predicates (at ?p - place) (ball ?p - place) (held) (free))"
        "(:action go :parameters (?x ?y - place) :precondition (at ?x) :effect (and (not (at ?x)) (at ?y)))"
        "(:action take :parameters (?p - place) :precondition (and (at ?p) (ball ?p) (free))"
        " :effect (and (held) (not (free)) (not (ball ?p))))"
        "(:action put :parameters (?p - place) :precondition (and (at ?p) (held))"
        " :effect (and (free) (not (held)) (ball ?p)))" +
            more + ")",
        "(define (problem p) (:domain carry) (:objects a b c - place)"
        "(:init (at a) (ball a) (free)) (:goal (ball b)))"};
}

struct Carrying {
    explicit Carrying(const Texts& texts = carrying())
        : task(ground(texts)), compilation(compile(task)), belief(compilation) {}
    std::uint32_t action(const std::string& name) const {
        for (std::uint32_t a = 0; a < task->operator_count(); ++a)
            if (task->physical->operator_name(OperatorId(a)) == name) return a;
        ADD_FAILURE() << name;
        return 0;
    }
    Truth operator()(const std::string& atom) const { return belief.truth(fact_of(*task, atom)); }

    std::shared_ptr<const BeliefTask> task;
    std::shared_ptr<const Compilation> compilation;
    Belief belief;
};

TEST(Failure, NeitherWayIsKnownAndPlansSupposeThatNothingHappened) {
    Carrying test;
    const auto supposed = test.belief.fail(test.action("(go a b)"));
    ASSERT_TRUE(supposed);
    EXPECT_EQ(to_string(*supposed, *test.task->physical), "Atom at(a)");
    EXPECT_EQ(test("(at a)"), Truth::unknown);
    EXPECT_EQ(test("(at b)"), Truth::unknown);
    EXPECT_EQ(test("(ball a)"), Truth::known_true);
    EXPECT_TRUE(test.belief.can(test.action("(go a b)")));
    EXPECT_FALSE(test.belief.can(test.action("(go b a)")));
}

TEST(Failure, AReadingTells) {
    for (const std::string place : {"a", "b"}) {
        Carrying test;
        test.belief.fail(test.action("(take a)"));
        test.belief.fail(test.action("(go a b)"));
        EXPECT_TRUE(test.belief.learn(fact_of(*test.task, "(at " + place + ")")));
        EXPECT_EQ(test("(at " + place + ")"), Truth::known_true);
        EXPECT_EQ(test("(held)"), Truth::unknown);
        // All of an action has happened, or nothing of it.
        EXPECT_TRUE(test.belief.learn(fact_of(*test.task, "(held)")));
        EXPECT_EQ(test("(ball a)"), Truth::known_false);
        EXPECT_FALSE(test.belief.in_doubt(fact_of(*test.task, "(held)").variable));
    }
}

TEST(Failure, AnActionThatIsExecutedTellsThatItWasPossible) {
    Carrying test;
    test.belief.fail(test.action("(go a b)"));
    test.belief.act(test.action("(take a)"));
    EXPECT_EQ(test("(at a)"), Truth::known_true);
    EXPECT_EQ(test("(held)"), Truth::known_true);
}

TEST(Failure, ARefusalTellsThatItWasNot) {
    Carrying test;
    EXPECT_FALSE(test.belief.refuse(test.action("(take a)")));  // nothing explains it
    test.belief.fail(test.action("(go a b)"));
    EXPECT_TRUE(test.belief.refuse(test.action("(take a)")));
    EXPECT_EQ(test("(at b)"), Truth::known_true);
    EXPECT_FALSE(test.belief.refuse(test.action("(go b a)")));
    EXPECT_EQ(test("(at b)"), Truth::known_true);
}

TEST(Failure, AnotherFailureMakesTheOtherWayTheSupposedOne) {
    Carrying test;
    test.belief.fail(test.action("(go a b)"));
    test.belief.fail(test.action("(go a b)"));
    EXPECT_TRUE(test.belief.supposes(fact_of(*test.task, "(at b)")));
    EXPECT_EQ(test("(at b)"), Truth::unknown);
    test.belief.suppose_otherwise();
    EXPECT_TRUE(test.belief.supposes(fact_of(*test.task, "(at a)")));
}

TEST(Failure, FingerprintsTellDoubtFromKnowledge) {
    Carrying one, other;
    const std::uint64_t known = one.belief.fingerprint();
    one.belief.fail(one.action("(go a b)"));
    EXPECT_NE(one.belief.fingerprint(), known);
    EXPECT_TRUE(one.belief.learn(fact_of(*one.task, "(at a)")));
    EXPECT_EQ(one.belief.fingerprint(), known);
}

TEST(Failure, TheGoalIsNotReachedAsLongAsItIsInDoubt) {
    Carrying test;
    for (const char* name : {"(take a)", "(go a b)"}) test.belief.act(test.action(name));
    test.belief.fail(test.action("(put b)"));
    EXPECT_FALSE(test.belief.goal_known());
    test.belief.refuse(test.action("(put b)"));
    EXPECT_TRUE(test.belief.goal_known());
}

/// The button (`press`) starts the motor, or it has failed; what `act` does may depend on that.
Carrying pressed(const std::string& act, const std::string& init = "", const std::string& more = "") {
    Carrying test(propositional("(on) (moved) (live) (lit) (dark)",
                                "(:action press :effect (on))\n(:action act " + act + ")\n" + more, init,
                                "(moved)"));
    test.belief.fail(test.action("(press)"));
    return test;
}

TEST(Failure, AnEffectThatDependsOnADoubtIsInDoubt) {
    const std::map<std::string, bool> conditions = {
        {"(on)", true}, {"(live)", true}, {"(not (live))", false}};
    for (const auto& [condition, when_on] : conditions) {
        for (const bool on : {false, true}) {
            Carrying test = pressed(":effect (when " + condition + " (moved))", "", "(:derived (live) (on))");
            EXPECT_EQ(test("(live)"), Truth::unknown);
            test.belief.act(test.action("(act)"));
            EXPECT_EQ(test("(moved)"), Truth::unknown) << condition;
            EXPECT_TRUE(test.belief.learn({fact_of(*test.task, "(on)").variable, on ? 0 : 1}));
            EXPECT_EQ(test("(moved)"), on == when_on ? Truth::known_true : Truth::known_false) << condition;
            EXPECT_FALSE(test.belief.in_doubt(fact_of(*test.task, "(moved)").variable));
        }
    }
}

TEST(Failure, AnUncertainEffectThatDependsOnADoubtIsNotKnown) {
    Carrying test = pressed(":effect (when (on) (moved))", "(unknown (moved))");
    EXPECT_TRUE(test.belief.learn({fact_of(*test.task, "(moved)").variable, 1}));
    EXPECT_EQ(test("(moved)"), Truth::known_false);
    test.belief.act(test.action("(act)"));
    EXPECT_EQ(test("(moved)"), Truth::unknown);
    EXPECT_TRUE(test.belief.learn(fact_of(*test.task, "(moved)")));
    EXPECT_EQ(test("(on)"), Truth::known_true);
}

TEST(Failure, CasesAreThoseOfAllHypotheses) {
    for (const bool fails : {false, true}) {
        Carrying test = pressed(":effect (when (and (on) (lit)) (moved))", "(oneof (lit) (dark))");
        const Fact moved = fact_of(*test.task, "(moved)");
        ASSERT_TRUE(test.compilation->tracked(moved.variable));
        EXPECT_EQ(test.belief.truth(moved), Truth::known_false);
        if (fails)
            test.belief.fail(test.action("(act)"));
        else
            test.belief.act(test.action("(act)"));
        EXPECT_EQ(test.belief.truth(moved), Truth::unknown);
        EXPECT_TRUE(test.belief.learn(moved));
        EXPECT_EQ(test("(lit)"), Truth::known_true);
        EXPECT_EQ(test("(dark)"), Truth::known_false);
    }
}

TEST(Failure, HypothesesAreJudgedByWhatWasKnownBeforeTheAction) {
    // `act` ends what makes it possible; `lit` is tracked, since `burn` depends on it.
    Carrying test = pressed(":precondition (and (lit) (not (on))) :effect (and (not (lit)) (moved))",
                            "(unknown (lit))", "(:action burn :effect (when (lit) (dark)))");
    const Fact lit = fact_of(*test.task, "(lit)");
    ASSERT_TRUE(test.compilation->tracked(lit.variable));
    EXPECT_TRUE(test.belief.learn(lit));
    test.belief.act(test.action("(act)"));
    EXPECT_EQ(test("(on)"), Truth::known_false);
    EXPECT_EQ(test("(lit)"), Truth::known_false);
}

TEST(Failure, ARefusalTellsByDerivedAtoms) {
    Carrying test = pressed(":precondition (not (live)) :effect (moved)", "",
                            "(:derived (live) (on)) (:action burn :effect (dark))");
    test.belief.fail(test.action("(burn)"));
    ASSERT_TRUE(test.belief.can(test.action("(act)")));
    EXPECT_TRUE(test.belief.refuse(test.action("(act)")));
    EXPECT_EQ(test("(on)"), Truth::known_true);
    EXPECT_EQ(test("(dark)"), Truth::unknown);
}

/// Every action fails once; `happens` says whether it does its work all the same.
class FailsOnce : public SimulatedWorld {
  public:
    FailsOnce(const Carrying& test, bool happens)
        : SimulatedWorld(test.task, test.task->initial_values), happens_(happens) {}
    Execution execute(std::uint32_t action, std::stop_token stop) override {
        if (!applicable(action) || !failed_.insert(action).second)
            return SimulatedWorld::execute(action, stop);
        if (happens_) SimulatedWorld::execute(action, stop);
        return {Execution::Status::failed, "the gripper slipped"};
    }

  private:
    bool happens_;
    std::set<std::uint32_t> failed_;
};

TEST(Failure, TheLoopFindsOutByTrying) {
    for (const bool happens : {false, true}) {
        Carrying test;
        FailsOnce world(test, happens);
        std::size_t failures = 0, suppositions = 0;
        const RunResult run = Agent(std::make_shared<const KnowledgePlanner>(test.compilation))
                                  .run(test.belief, world, {}, [&](const Event& event, const Belief&) {
                                      failures += event.kind == Event::Kind::failed;
                                      suppositions += event.kind == Event::Kind::supposed;
                                  });
        EXPECT_EQ(run.status, RunStatus::reached) << run.message;
        EXPECT_TRUE(world.goal_holds());
        EXPECT_EQ(world.happened().size(), 3u);
        EXPECT_EQ(run.actions.size(), 6u);
        EXPECT_EQ(failures, happens ? 6u : 3u);  // failed, then refused
        EXPECT_GE(suppositions, 3u);
    }
}

TEST(Failure, AWorldThatRefusesWithoutADoubtEndsTheRun) {
    Carrying test;
    class Refuses : public SimulatedWorld {
      public:
        using SimulatedWorld::SimulatedWorld;
        Execution execute(std::uint32_t, std::stop_token) override {
            return {Execution::Status::illegal, "no"};
        }
    } world(test.task, test.task->initial_values);
    const RunResult run =
        Agent(std::make_shared<const KnowledgePlanner>(test.compilation)).run(test.belief, world);
    EXPECT_EQ(run.status, RunStatus::illegal);
    EXPECT_EQ(run.message, "no");
}

TEST(Failure, ARobotIsAskedWhatTheActionMayHaveChanged) {
    struct Robot : Skills, Observer {
        Execution execute(const ActionName&, std::span<const double> parameters, std::stop_token) override {
            EXPECT_TRUE(parameters.empty());
            return {Execution::Status::failed, ""};
        }
        Percept observe(const ObservationRequest& request, std::stop_token) override {
            asked.assign(request.questions.begin(), request.questions.end());
            return {};
        }
        std::vector<AtomName> asked;
    } robot;
    const Carrying test;
    RobotEnvironment environment(test.task, robot, robot);
    environment.observe(Environment::kStart, {});
    EXPECT_TRUE(robot.asked.empty());
    const std::uint32_t action = test.action("(take a)");
    environment.execute(action, {});
    environment.observe(action, {});
    for (const AtomName& atom : {AtomName{{"held"}}, AtomName{{"ball", "a"}}})
        EXPECT_TRUE(std::find(robot.asked.begin(), robot.asked.end(), atom) != robot.asked.end());
    EXPECT_TRUE(std::none_of(robot.asked.begin(), robot.asked.end(),
                             [](const AtomName& atom) { return atom.words[0] == "at"; }));
}

TEST(Failure, ProbabilitiesAreChecked) {
    const Carrying test;
    for (const double wrong : {-0.1, 1.1, std::nan("")})
        EXPECT_THROW(SimulatedWorld(test.task, test.task->initial_values, 0, 0, wrong),
                     std::invalid_argument);
}

TEST(Failure, HalfOfTheFailedActionsHappen) {
    const Carrying test;
    std::size_t happened = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        SimulatedWorld world(test.task, test.task->initial_values, 0, seed, 1);
        EXPECT_EQ(world.execute(test.action("(go a b)")).status, Execution::Status::failed);
        happened += world.happened().size();
    }
    EXPECT_GT(happened, 150u);
    EXPECT_LT(happened, 250u);
}

class Unreliable : public testing::TestWithParam<const char*> {};

TEST_P(Unreliable, SkillsReachTheGoal) {
    const std::string name = GetParam(), root = PRAXIS_SOURCE_DIR;
    const std::string domain = name.substr(0, name.find('/'));
    const auto task = ground_belief(load_contingent(root + "/domains/belief/" + domain + "/domain.pddl",
                                                    root + "/problems/belief/" + name + ".pddl")
                                        .task)
                          .task;
    const auto compilation = compile(task);
    const Agent agent(std::make_shared<const KnowledgePlanner>(compilation));
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        const WorldState first = sample_world(*task, random).value();
        SimulatedWorld world(task, first, 0, seed, 0.3);
        Belief belief(compilation);
        const RunResult run = agent.run(belief, world);
        EXPECT_EQ(run.status, RunStatus::reached) << seed << " " << run.message;
        EXPECT_TRUE(world.goal_holds());
        EXPECT_TRUE(check_run(*task, first, world.happened(), world.after_chance()).valid);
    }
}

INSTANTIATE_TEST_SUITE_P(Tasks, Unreliable,
                         testing::Values("sort-weight/two-boxes", "drawer-cleaning/two-drawers",
                                         "cup-pick-place/two-cups", "cup-removal/three-cups"));

/// What is known holds, whatever fails on the way.
void known_is_true(const Constructs& constructs) {
    const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
    std::shared_ptr<const BeliefTask> task;
    try {
        task = ground(random_contingent(seed, constructs));
    } catch (const InputError&) {
        return;
    }
    Random random(seed);
    const auto first = sample_world(*task, random);
    if (!first) return;
    Belief belief(compile(task));
    SimulatedWorld world(task, *first, 0, seed, 0.4);
    const auto read = [&](std::uint32_t action) {
        for (const Answer& answer : world.observe(action)) RC_ASSERT(belief.learn(answer.fact));
    };
    read(Environment::kStart);
    for (int step = 0; step < 25; ++step) {
        std::vector<std::uint32_t> possible;
        for (std::uint32_t action = 0; action < task->operator_count(); ++action)
            if (belief.can(action)) possible.push_back(action);
        if (possible.empty()) break;
        const std::uint32_t action = possible[random.below(possible.size())];
        RC_LOG() << task->physical->operator_name(OperatorId(action)) << "\n";
        switch (world.execute(action).status) {
            case Execution::Status::done:
                belief.act(action);
                break;
            case Execution::Status::failed:
                belief.fail(action);
                break;
            case Execution::Status::illegal:
                RC_ASSERT(belief.refuse(action).has_value());
                continue;
        }
        read(action);
        for (std::size_t v = 0; v < world.state().size(); ++v) {
            const std::int32_t known = belief.value(static_cast<std::int32_t>(v));
            RC_ASSERT(known == BeliefTask::kUnknown || known == world.state()[v]);
        }
    }
}

RC_GTEST_PROP(FailureProperties, WhatIsKnownIsTrue, ()) {
    known_is_true({});
}

RC_GTEST_PROP(FailureProperties, WhatIsKnownIsTrueWithModels, ()) {
    known_is_true({.derived = false, .models = true});
}

}  // namespace
}  // namespace praxis::belief::test
