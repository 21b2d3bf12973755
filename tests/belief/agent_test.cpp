// The loop, example by example: how runs end, and what is told of them.
#include "belief/agent.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "belief/check_run.hpp"
#include "belief/simulated_world.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

/// A world that answers and acts as the test says; without that as the simulated one.
class Scripted : public Environment {
  public:
    explicit Scripted(SimulatedWorld& world) : world_(world) {}

    Execution execute(std::uint32_t action, std::stop_token stop) override {
        ++executed;
        return on_execute ? on_execute(action) : world_.execute(action, stop);
    }
    std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) override {
        return on_observe ? on_observe(action) : world_.observe(action, stop);
    }

    std::function<Execution(std::uint32_t)> on_execute;
    std::function<std::vector<Answer>(std::uint32_t)> on_observe;
    std::size_t executed = 0;

  private:
    SimulatedWorld& world_;
};

class Case {
  public:
    /// The world where the atoms of `true_atoms` hold of those that are uncertain.
    Case(const Texts& texts, const std::string& true_atoms = "") {
        Texts with_world = texts;
        with_world.worlds = {"(define (problem w) (:hidden " + true_atoms + "))"};
        task = ground(with_world);
        // Grounding leaves out the worlds where it proves that there is no plan.
        first = task->worlds.size() > 0 ? hidden_world(*task, 0) : task->initial_values;
        planner = std::make_shared<const KnowledgePlanner>(compile(task));
        world = std::make_unique<SimulatedWorld>(task, first);
        scripted = std::make_unique<Scripted>(*world);
        options = default_agent_options();
    }

    RunResult run(const Budget& budget = {}) {
        Belief belief(planner->shared_compilation());
        events.clear();
        return Agent(planner, options).run(belief, *scripted, budget, [&](const Event& event, const Belief&) {
            static constexpr const char* kKinds[] = {"planned",  "executed", "failed", "read",
                                                     "finished", "supposed", "found"};
            events.push_back(std::string(kKinds[static_cast<int>(event.kind)]) +
                             (event.kind == Event::Kind::planned ? "" : " " + event.text));
        });
    }
    std::string steps(const RunResult& result) const {
        std::string text;
        for (std::uint32_t action : result.actions) text += task->physical->operator_name(OperatorId(action));
        return text;
    }

    std::shared_ptr<const BeliefTask> task;
    WorldState first;
    std::shared_ptr<const KnowledgePlanner> planner;
    std::unique_ptr<SimulatedWorld> world;
    std::unique_ptr<Scripted> scripted;
    AgentOptions options;
    std::vector<std::string> events;
};

/// Three boxes, one ball: look into them one by one, then take it.
Texts boxes() {
    return {
        "(define (domain boxes) (:types box) (:predicates (in ?b - box) (have))"
        "(:action look :parameters (?b - box) :observe (in ?b))"
        "(:action take :parameters (?b - box) :precondition (in ?b) :effect (and (have) (not (in ?b)))))",
        "(define (problem three) (:domain boxes) (:objects b1 b2 b3 - box)"
        "(:init (oneof (in b1) (in b2) (in b3))) (:goal (have)))"};
}

TEST(Agent, FindsTheBallInEveryBox) {
    for (const std::string box : {"b1", "b2", "b3"}) {
        Case test(boxes(), "(in " + box + ")");
        const RunResult result = test.run();
        EXPECT_EQ(result.status, RunStatus::reached) << result.message;
        EXPECT_TRUE(test.world->goal_holds());
        EXPECT_LE(result.actions.size(), 3u);
        EXPECT_TRUE(test.steps(result).ends_with("(take " + box + ")")) << test.steps(result);
        const Verdict verdict = check_run(*test.task, test.first, result.actions);
        EXPECT_TRUE(verdict.valid) << verdict.reason;
        EXPECT_EQ(verdict.cost, Rational(static_cast<std::int64_t>(result.actions.size())));
    }
}

TEST(Agent, CheckedInAnotherWorldTheRunIsNotValid) {
    Case test(boxes(), "(in b1)"), other(boxes(), "(in b2)");
    const RunResult result = test.run();
    const Verdict verdict = check_run(*test.task, other.first, result.actions);
    EXPECT_FALSE(verdict.valid);
    EXPECT_EQ(verdict.step, result.actions.size());
    EXPECT_FALSE(check_run(*test.task, test.first, {}).valid);
}

TEST(Agent, TellsWhatHappens) {
    Case test(boxes(), "(in b2)");
    const RunResult result = test.run();
    ASSERT_GE(test.events.size(), 4u);
    EXPECT_EQ(test.events.front(), "planned");
    EXPECT_EQ(test.events.back(), "finished reached");
    std::size_t executed = 0, planned = 0, read = 0;
    for (const std::string& event : test.events) {
        executed += event.starts_with("executed");
        planned += event == "planned";
        read += event.starts_with("read");
    }
    EXPECT_EQ(executed, result.actions.size());
    EXPECT_EQ(planned, result.plans);
    EXPECT_EQ(result.plan_seconds.size(), result.plans);
    EXPECT_EQ(read, executed - 1);
}

TEST(Agent, AGoalThatHoldsNeedsNoPlan) {
    Case empty(propositional("(p)", "(:action a :parameters () :effect (p))", "(unknown (p))", "(and)"));
    EXPECT_EQ(empty.run().status, RunStatus::reached);
    EXPECT_EQ(empty.run().plans, 0u);
    EXPECT_EQ(empty.run().actions.size(), 0u);
    Case nothing(propositional("(p)", "", "(p)", "(p)"));
    EXPECT_EQ(nothing.run().status, RunStatus::reached);
}

TEST(Agent, ASensorAtTheStartMayTellAll) {
    Case test(
        propositional(
            "(p) (q)",
            "(:action a :parameters () :effect (p)) (:sensor s :parameters () :condition (q) :sense (p))",
            "(q) (unknown (p))", "(p)"),
        "(p)");
    const RunResult result = test.run();
    EXPECT_EQ(result.status, RunStatus::reached);
    EXPECT_EQ(result.plans, 0u);
}

TEST(Agent, WithoutAPlanWhateverIsTrueItIsInfeasible) {
    Case test(propositional("(p) (g)", "(:action look :parameters () :observe (p))", "(unknown (p))", "(g)"));
    const RunResult result = test.run();
    EXPECT_EQ(result.status, RunStatus::infeasible);
    EXPECT_NE(result.message, "");
}

TEST(Agent, WhatCannotBeFoundOutIsNotFound) {
    Case test(propositional("(p) (g)",
                            "(:action a :parameters () :precondition (p) :effect (g))"
                            "(:action b :parameters () :precondition (g) :effect (not (p)))",
                            "(unknown (p))", "(g)"),
              "(p)");
    EXPECT_EQ(test.run().status, RunStatus::not_found);
    EXPECT_EQ(test.scripted->executed, 0u);
}

TEST(Agent, TheStepLimitHolds) {
    Case test(boxes(), "(in b3)");
    test.options.most_steps = 1;
    const RunResult result = test.run();
    EXPECT_EQ(result.status, RunStatus::step_limit);
    EXPECT_EQ(result.actions.size(), 1u);
    test.options.most_steps = 0;
    EXPECT_EQ(test.run().status, RunStatus::step_limit);
}

TEST(Agent, TheLimitOfPlansHolds) {
    Case test(boxes(), "(in b3)");
    test.options.most_plans = 0;
    const RunResult result = test.run();
    EXPECT_EQ(result.status, RunStatus::step_limit);
    EXPECT_EQ(result.plans, 0u);
}

TEST(Agent, StopsWhenAsked) {
    Case test(boxes(), "(in b3)");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(test.run(Budget().stop_with(stop.get_token())).status, RunStatus::interrupted);
    EXPECT_EQ(test.scripted->executed, 0u);
    // In the middle of the run, too; what has been done is kept.
    std::stop_source later;
    test.scripted->on_execute = [&](std::uint32_t action) {
        later.request_stop();
        return test.world->execute(action);
    };
    const RunResult result = test.run(Budget().stop_with(later.get_token()));
    EXPECT_EQ(result.status, RunStatus::interrupted);
    EXPECT_EQ(result.actions.size(), 1u);
}

TEST(Agent, StopsWhenTheTimeIsOver) {
    Case test(boxes(), "(in b3)");
    Budget budget;
    budget.limit_wall_time(0);
    EXPECT_EQ(test.run(budget).status, RunStatus::out_of_time);
}

TEST(Agent, AWorldThatRefusesEndsTheRun) {
    Case test(boxes(), "(in b1)");
    test.scripted->on_execute = [](std::uint32_t) {
        return Execution{Execution::Status::illegal, "the arm is locked"};
    };
    const RunResult result = test.run();
    EXPECT_EQ(result.status, RunStatus::illegal);
    EXPECT_EQ(result.message, "the arm is locked");
    EXPECT_EQ(test.scripted->executed, 1u);
}

TEST(Agent, AnActionThatFailsOnceIsTriedAgain) {
    Case test(boxes(), "(in b1)");
    bool failed = false;
    test.scripted->on_execute = [&](std::uint32_t action) {
        if (!failed && test.task->physical->operator_name(OperatorId(action)).starts_with("(take")) {
            failed = true;
            return Execution{Execution::Status::failed, "slipped"};
        }
        return test.world->execute(action);
    };
    const RunResult result = test.run();
    EXPECT_TRUE(failed);
    EXPECT_EQ(result.status, RunStatus::reached);
    EXPECT_TRUE(test.world->goal_holds());
}

TEST(Agent, AnActionThatAlwaysFailsEndsAsStuck) {
    Case test(boxes(), "(in b1)");
    test.scripted->on_execute = [&](std::uint32_t action) {
        if (test.task->physical->operator_name(OperatorId(action)).starts_with("(take"))
            return Execution{Execution::Status::failed, "slipped"};
        return test.world->execute(action);
    };
    EXPECT_EQ(test.run().status, RunStatus::stuck);
}

TEST(Agent, ReadingsThatNeverComeEndAsStuck) {
    Case test(boxes(), "(in b1)");
    test.scripted->on_observe = [](std::uint32_t) { return std::vector<Answer>{}; };
    EXPECT_EQ(test.run().status, RunStatus::stuck);
}

TEST(Agent, AContradictionEndsTheRunOrIsPassedOver) {
    Case test(boxes(), "(in b2)");
    bool lied = false;
    // After what is read truly comes the opposite.
    test.scripted->on_observe = [&](std::uint32_t action) {
        std::vector<Answer> answers = test.world->observe(action);
        if (!answers.empty()) {
            lied = true;
            Answer lie = answers.front();
            lie.fact.value = 1 - lie.fact.value;
            answers.push_back(lie);
        }
        return answers;
    };
    const RunResult result = test.run();
    EXPECT_TRUE(lied);
    EXPECT_EQ(result.status, RunStatus::contradiction);
    EXPECT_NE(result.message, "");
    Case patient(boxes(), "(in b2)");
    patient.options.ignore_contradictions = true;
    patient.scripted->on_observe = [&](std::uint32_t action) {
        std::vector<Answer> answers = patient.world->observe(action);
        if (!answers.empty()) {
            answers.push_back(answers.front());
            answers.back().fact.value = 1 - answers.back().fact.value;
        }
        return answers;
    };
    EXPECT_EQ(patient.run().status, RunStatus::reached);
    EXPECT_TRUE(patient.world->goal_holds());
}

TEST(Agent, NoFirstStateIsAContradiction) {
    const auto task = ground(propositional(
        "(p) (q) (g)",
        "(:action a :parameters () :precondition (p) :effect (g)) (:action l :parameters () :observe (q))",
        "(oneof (p) (q)) (oneof (p)) (oneof (q))", "(g)"));
    const auto planner = std::make_shared<const KnowledgePlanner>(compile(task));
    Belief belief(planner->shared_compilation());
    EXPECT_FALSE(belief.consistent());
    SimulatedWorld world(task, WorldState(task->initial_values.size(), 0));
    EXPECT_EQ(Agent(planner).run(belief, world).status, RunStatus::contradiction);
}

TEST(Agent, SeveralReadingsOfAnActionThatCanBeDoneOnce) {
    const Texts texts = {
        "(define (domain once) (:types box) (:predicates (in ?b - box) (closed) (have))"
        "(:action open :parameters () :precondition (closed) :effect (not (closed))"
        " :observe (forall (?b - box) (in ?b)))"
        "(:action take :parameters (?b - box) :precondition (in ?b) :effect (have)))",
        "(define (problem p) (:domain once) (:objects b1 b2 b3 - box)"
        "(:init (closed) (oneof (in b1) (in b2) (in b3))) (:goal (have)))"};
    for (const std::string box : {"b1", "b2", "b3"}) {
        Case test(texts, "(in " + box + ")");
        const RunResult result = test.run();
        EXPECT_EQ(result.status, RunStatus::reached) << result.message;
        EXPECT_EQ(test.steps(result), "(open)(take " + box + ")");
    }
}

TEST(Agent, ActsByCasesWhereNothingCanBeRead) {
    // A conformant task: the lever's position decides, pulling it twice always helps.
    const Texts texts = propositional("(up) (open)",
                                      "(:action pull :parameters () :effect"
                                      " (and (when (up) (open)) (when (not (up)) (up))))",
                                      "(unknown (up))", "(open)");
    for (const std::string up : {"", "(up)"}) {
        Case test(texts, up);
        const RunResult result = test.run();
        EXPECT_EQ(result.status, RunStatus::reached) << result.message;
        EXPECT_TRUE(test.world->goal_holds());
        EXPECT_EQ(result.actions.size(), 2u);
    }
}

TEST(Agent, StatusesHaveNames) {
    for (int status = 0; status <= static_cast<int>(RunStatus::contradiction); ++status)
        EXPECT_STRNE(to_string(static_cast<RunStatus>(status)), "");
    EXPECT_STREQ(to_string(RunStatus::step_limit), "step limit");
}

}  // namespace
}  // namespace praxis::belief::test
