#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "tests/belief/policies/support.hpp"

namespace praxis::belief::test {
namespace {

/// Reads nothing and refuses nothing; records what is executed.
class Recorder : public Environment {
  public:
    explicit Recorder(SimulatedWorld& world) : world_(world) {}
    Execution execute(std::uint32_t action, std::stop_token stop) override {
        possible.push_back(world_.applicable(action));
        return world_.execute(action, stop);
    }
    std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) override {
        return world_.observe(action, stop);
    }
    std::vector<bool> possible;

  private:
    SimulatedWorld& world_;
};

TEST(Policies, AreKnownByName) {
    const Loaded loaded = load_own("drawer-cleaning", "one-drawer");
    for (const PolicyKind& kind : policy_kinds()) EXPECT_TRUE(make_policy(kind.name, loaded.context()));
    try {
        make_policy("magic", loaded.context());
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("'magic'"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("sense-first"), std::string::npos);
    }
}

TEST(Policies, AGoalThatIsKnownNeedsNoAction) {
    const Loaded loaded =
        load_text("(define (domain d) (:predicates (p) (q)) (:action look :parameters () :observe (q)))",
                  "(define (problem p) (:domain d) (:init (p) (unknown (q))) (:goal (p)))");
    for (const PolicyKind& kind : policy_kinds()) {
        const PolicyResult result = run_named(loaded, kind.name, 1);
        EXPECT_EQ(result.run.status, RunStatus::reached) << kind.name;
        EXPECT_EQ(result.steps, 0U) << kind.name;
    }
}

RC_GTEST_PROP(RandomPolicyProperty, KnownActionsAreAlwaysPossible, ()) {
    static const Loaded loaded[] = {load_own("sort-weight", "two-boxes"), load_own("wumpus", "one-monster"),
                                    load_own("lost-robot", "small"), load_own("same-colour", "two-cups")};
    const Loaded& task = loaded[*rc::gen::inRange(0, 4)];
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const PolicyContext context = task.context(seed, 50);
    const auto policy = make_policy("random", context);
    Belief belief = task.belief();
    SimulatedWorld world(task.task, sample(task, seed), 0, seed);
    Recorder recorder(world);
    const PolicyResult result = run_policy(*policy, context, belief, recorder);
    for (const bool possible : recorder.possible) RC_ASSERT(possible);
    RC_ASSERT(result.run.status == RunStatus::reached || result.run.status == RunStatus::step_limit ||
              result.run.status == RunStatus::stuck);
    RC_ASSERT((result.run.status == RunStatus::reached) == belief.goal_known());
    if (belief.goal_known()) RC_ASSERT(world.goal_holds());
    RC_ASSERT(result.steps == result.run.actions.size());
}

RC_GTEST_PROP(RandomPolicyProperty, RefusedActionsOnlyCount, ()) {
    static const Loaded task = load_own("cup-removal", "three-cups");
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const WorldState first = sample(task, seed);
    const PolicyContext context = task.context(seed, 200);
    const auto policy = make_policy("random-any", context);
    Belief belief = task.belief();
    SimulatedWorld world(task.task, first, 0, seed);
    Recorder recorder(world);
    const PolicyResult result = run_policy(*policy, context, belief, recorder);
    std::size_t done = 0;
    for (const bool possible : recorder.possible) done += possible;
    RC_ASSERT(result.steps == recorder.possible.size());
    RC_ASSERT(result.run.actions.size() == done);
    SimulatedWorld again(task.task, first);
    for (const std::uint32_t action : result.run.actions)
        RC_ASSERT(again.execute(action).status == Execution::Status::done);
    RC_ASSERT(again.state() == world.state());
    // What is known is true: also what was learnt from an action that happened to be possible.
    for (std::size_t v = 0; v < again.state().size(); ++v) {
        const Fact fact{static_cast<std::int32_t>(v), again.state()[v]};
        if (!task.task->physical->derived(fact.variable)) RC_ASSERT(belief.truth(fact) != Truth::known_false);
    }
}

TEST(RandomPolicy, LearnsFromAnActionThatWasPossible) {
    // Whether the key fits can only be seen by turning it.
    const Loaded task = load_text(
        "(define (domain d) (:predicates (fits) (turned))"
        " (:action turn :parameters () :precondition (fits) :effect (turned)))",
        "(define (problem p) (:domain d) (:init (unknown (fits))) (:goal (and (fits) (turned))))");
    std::size_t reached = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const PolicyResult result = run_named(task, "random-any", seed, 10);
        const bool fits = !result.run.actions.empty();
        EXPECT_EQ(result.run.status, fits ? RunStatus::reached : RunStatus::step_limit);
        EXPECT_EQ(result.steps, fits ? 1U : 10U);
        EXPECT_EQ(run_named(task, "random", seed, 10).run.status, RunStatus::stuck);
        reached += fits;
    }
    EXPECT_GT(reached, 0U);
    EXPECT_LT(reached, 20U);
}

TEST(RandomPolicy, ChoosesUniformly) {
    const Loaded task = load_own("drawer-cleaning", "one-drawer");
    const std::size_t count = task.task->operator_count();
    const auto policy = make_policy("random-any", task.context(7));
    Belief belief = task.belief();
    std::vector<std::size_t> chosen(count);
    const std::size_t trials = 2000 * count;
    for (std::size_t i = 0; i < trials; ++i) ++chosen.at(policy->next(belief, {}).action);
    double statistic = 0;  // chi-squared, `count - 1` degrees of freedom
    for (const std::size_t n : chosen) {
        const double difference = static_cast<double>(n) - 2000;
        statistic += difference * difference / 2000;
    }
    EXPECT_LT(statistic, 3 * static_cast<double>(count));
}

TEST(PlanPolicy, ActsAsTheLoopDoes) {
    for (const auto& [domain, problem] : {std::pair{"sort-weight", "two-in-cupboards"},
                                          {"doors", "three-walls"},
                                          {"ball-sorting", "two-balls"},
                                          {"lost-robot", "small"}}) {
        const Loaded task = load_own(domain, problem);
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            const PolicyResult ours = run_named(task, "plan", seed);
            Belief belief = task.belief();
            SimulatedWorld world(task.task, sample(task, seed), 0, seed);
            const RunResult theirs = Agent(task.planner).run(belief, world);
            EXPECT_EQ(ours.run.status, theirs.status);
            EXPECT_EQ(ours.run.actions, theirs.actions);
            EXPECT_EQ(ours.run.plans, theirs.plans);
        }
    }
}

TEST(SenseFirst, ReadsWhatDoesNotMatter) {
    const Loaded task = load_own("cup-pick-place", "two-cups");
    const PolicyResult plan = run_named(task, "plan", 3);
    const PolicyResult sense = run_named(task, "sense-first", 3);
    EXPECT_EQ(plan.steps, 4U);
    EXPECT_EQ(sense.steps, 6U);
    EXPECT_EQ(sense.run.status, RunStatus::reached);
}

TEST(SenseFirst, KnowsEverythingBeforeItActsAndSucceeds) {
    const Loaded task = load_own("drawer-inspection", "two-drawers");
    std::size_t plan_steps = 0, sense_steps = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const WorldState first = sample(task, seed);
        const auto policy = make_policy("sense-first", task.context());
        Belief belief = task.belief();
        SimulatedWorld world(task.task, first);
        std::size_t unknown_when_taking = 0;
        const auto watch = [&](const Event& event, const Belief& now) {
            if (event.kind != Event::Kind::executed) return;
            if (task.task->physical->operator_name(OperatorId(event.action)).substr(0, 6) != "(take ") return;
            for (std::size_t v = 0; v < first.size(); ++v)
                unknown_when_taking += task.task->initial_values[v] == BeliefTask::kUnknown &&
                                       now.truth({static_cast<std::int32_t>(v), 0}) == Truth::unknown;
        };
        const PolicyResult result = run_policy(*policy, task.context(), belief, world, {}, watch);
        EXPECT_EQ(result.run.status, RunStatus::reached) << seed;
        EXPECT_TRUE(check_run(*task.task, first, result.run.actions).valid) << seed;
        EXPECT_EQ(unknown_when_taking, 0U) << seed;
        EXPECT_EQ(result.run.plans, result.run.plan_seconds.size());
        sense_steps += result.steps;
        plan_steps += run_named(task, "plan", seed).steps;
    }
    EXPECT_GT(sense_steps, plan_steps);
}

TEST(SenseFirst, ReadsTheNearestFirst) {
    const std::string domain =
        "(define (domain d) (:requirements :typing) (:types spot) (:predicates (at ?s - spot) (lit ?s - spot)"
        " (lamp ?s - spot) (next ?s ?t - spot) (done)) (:action go :parameters (?s ?t - spot)"
        " :precondition (and (at ?s) (next ?s ?t)) :effect (and (not (at ?s)) (at ?t)))"
        " (:action look :parameters (?s - spot) :precondition (and (at ?s) (lamp ?s)) :observe (lit ?s))"
        " (:action finish :parameters () :effect (done)))";
    const std::string lamps = " (lamp s1) (unknown (lit s1)) (lamp s6) (unknown (lit s6))";
    std::string ways;
    for (int i = 1; i < 6; ++i) {
        const std::string a = "s" + std::to_string(i), b = "s" + std::to_string(i + 1);
        ways += " (next " + a + " " + b + ") (next " + b + " " + a + ")";
    }
    for (const auto& [start, first] : {std::pair{"s3", "(go s3 s2)"}, {"s4", "(go s4 s5)"}}) {
        const Loaded task = load_text(
            domain, "(define (problem p) (:domain d) (:objects s1 s2 s3 s4 s5 s6 - spot) (:init (at " +
                        std::string(start) + ")" + lamps + ways + ") (:goal (done)))");
        const PolicyResult result = run_named(task, "sense-first", 1);
        EXPECT_EQ(result.run.status, RunStatus::reached);
        EXPECT_EQ(result.steps, 10U);  // 2 to the nearer one, 5 to the other, two looks, the end
        ASSERT_FALSE(result.run.actions.empty());
        EXPECT_EQ(task.task->physical->operator_name(OperatorId(result.run.actions[0])), first);
    }
}

TEST(SenseFirst, GivesUpWhatTheObserverCannotTell) {
    // Nobody answers: after a few attempts at each fact it plans, and the plan's own readings fail, too.
    class Silent : public SimulatedWorld {
      public:
        using SimulatedWorld::SimulatedWorld;
        std::vector<Answer> observe(std::uint32_t, std::stop_token) override { return {}; }
    };
    const Loaded task = load_own("doors", "two-walls");
    const auto policy = make_policy("sense-first", task.context());
    Belief belief = task.belief();
    Silent world(task.task, sample(task, 1));
    const PolicyResult result = run_policy(*policy, task.context(), belief, world);
    EXPECT_EQ(result.run.status, RunStatus::stuck);
    EXPECT_LT(result.steps, 100U);
}

TEST(RunPolicy, EndsAtItsLimits) {
    const Loaded task = load_own("drawer-inspection", "two-drawers");
    EXPECT_EQ(run_named(task, "plan", 1, 3).run.status, RunStatus::step_limit);
    EXPECT_EQ(run_named(task, "plan", 1, 3).steps, 3U);
    // Also where the limit falls into the loop after a policy's own steps.
    const PolicyResult whole = run_named(task, "sense-first", 1);
    ASSERT_EQ(whole.run.status, RunStatus::reached);
    ASSERT_EQ(whole.steps, whole.run.actions.size());
    for (std::size_t limit = 0; limit < whole.steps; ++limit) {
        const PolicyResult cut = run_named(task, "sense-first", 1, limit);
        EXPECT_EQ(cut.run.status, RunStatus::step_limit);
        EXPECT_EQ(cut.steps, limit);
    }
    EXPECT_EQ(run_named(task, "random-any", 1, 7).steps, 7U);

    const auto policy = make_policy("random", task.context());
    Belief belief = task.belief();
    SimulatedWorld world(task.task, sample(task, 1));
    std::stop_source source;
    source.request_stop();
    Budget budget;
    budget.stop_with(source.get_token());
    EXPECT_EQ(run_policy(*policy, task.context(), belief, world, budget).run.status, RunStatus::interrupted);
}

TEST(RunPolicy, ContradictionsEndTheRunOrAreIgnored) {
    const Loaded task = load_own("doors", "three-walls");
    std::size_t contradictions = 0, longer = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const PolicyResult strict = run_named(task, "random", seed, 300, 0.3);
        contradictions += strict.run.status == RunStatus::contradiction;
        const PolicyResult sticky = run_named(task, "random", seed, 300, 0.3, true);
        EXPECT_NE(sticky.run.status, RunStatus::contradiction);
        longer += sticky.steps > strict.steps;
    }
    EXPECT_GT(contradictions, 0U);
    EXPECT_GE(longer, contradictions);
}

TEST(RunPolicy, WhatTheWorldRefusesIsIllegalForWhoBelievesItPossible) {
    // A lie about a weight, believed: the box is dropped though it is heavy.
    class Liar : public SimulatedWorld {
      public:
        using SimulatedWorld::SimulatedWorld;
        std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) override {
            std::vector<Answer> answers = SimulatedWorld::observe(action, stop);
            for (Answer& answer : answers) answer.fact.value = 1 - answer.fact.value;
            return answers;
        }
    };
    const Loaded task = load_own("sort-weight", "one-box");
    std::size_t illegal = 0, false_successes = 0;
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const auto policy = make_policy("plan", task.context());
        Belief belief = task.belief();
        Liar world(task.task, sample(task, seed));
        const PolicyResult result = run_policy(*policy, task.context(), belief, world);
        illegal += result.run.status == RunStatus::illegal;
        false_successes += result.run.status == RunStatus::reached && !world.goal_holds();
    }
    EXPECT_GT(illegal, 0U);
    EXPECT_EQ(illegal + false_successes, 10U);
}

}  // namespace
}  // namespace praxis::belief::test
