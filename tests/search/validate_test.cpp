#include "search/validate.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>

#include "parser/parser.hpp"
#include "tests/search/support/naive_validator.hpp"
#include "tests/search/support/random_task.hpp"

namespace praxis {
namespace {

/// A task of one type "thing" with three things a, b, c unless the problem's parts say otherwise.
Task task_of(const std::string& domain_body, const std::string& init, const std::string& goal,
             const std::string& more = "", const std::string& objects = "a b c - thing") {
    const std::string domain = "(define (domain d) (:requirements :adl :derived-predicates :action-costs)\n" +
                               std::string("(:types thing nothing)\n") + domain_body + ")";
    const std::string problem = "(define (problem p) (:domain d) (:objects " + objects + ")\n(:init " + init +
                                ")\n(:goal " + goal + ")" + more + ")";
    return parse_task({"domain.pddl", domain}, {"problem.pddl", problem}).task;
}

Verdict run(const Task& task, const std::string& plan) {
    return validate(*task, parse_plan({"plan.txt", plan}, *task).plan);
}

constexpr const char* kGripper =
    R"((:predicates (ball-at ?b ?r - thing) (here ?r - thing) (free) (holds ?b - thing))
(:action move :parameters (?from ?to - thing) :precondition (here ?from) :effect (and (not (here ?from)) (here ?to)))
(:action pick :parameters (?b ?r - thing)
  :precondition (and (here ?r) (and (ball-at ?b ?r) (free)))
  :effect (and (holds ?b) (not (ball-at ?b ?r)) (not (free))))
(:action drop :parameters (?b ?r - thing) :precondition (and (here ?r) (holds ?b))
  :effect (and (ball-at ?b ?r) (free) (not (holds ?b)))))";

Task gripper() {
    return task_of(kGripper, "(ball-at a b) (here b) (free)", "(and (ball-at a c) (free))");
}

TEST(Validate, AcceptsAPlanAndCountsItsSteps) {
    const Verdict verdict = run(gripper(), "(pick a b)(move b c)(drop a c)");
    EXPECT_TRUE(verdict.valid) << verdict.reason;
    EXPECT_EQ(verdict.step, 0U);
    EXPECT_EQ(verdict.cost, Rational(3));
    EXPECT_EQ(verdict.reason, "");
}

TEST(Validate, NamesTheStepAndTheConditionsThatFail) {
    const Verdict verdict = run(gripper(), "(pick a b)(move b c)(pick a b)");
    EXPECT_FALSE(verdict.valid);
    EXPECT_EQ(verdict.step, 3U);
    EXPECT_EQ(verdict.cost, Rational(2));
    EXPECT_EQ(
        verdict.reason,
        "step 3 (pick a b): precondition (here b) does not hold (domain.pddl:6:22); nor does (ball-at a b) "
        "(domain.pddl:6:37); nor does (free) (domain.pddl:6:53)");
}

TEST(Validate, NamesTheGoalsThatFail) {
    const Verdict verdict = run(gripper(), "(pick a b)");
    EXPECT_EQ(verdict.step, 2U);
    EXPECT_EQ(verdict.reason,
              "the goal is not reached: (ball-at a c) does not hold (problem.pddl:3:13); nor does (free) "
              "(problem.pddl:3:27)");
}

TEST(Validate, AUniversalConditionFailsWithACounterexample) {
    const Task task = task_of(
        "(:predicates (p ?x - thing) (q ?x ?y - thing)) (:action go :precondition (forall (?x ?y - "
        "thing) (imply (q ?x ?y) (p ?y))))",
        "(q a b) (p a)", "(and)");
    const Verdict verdict = run(task, "(go)");
    EXPECT_NE(verdict.reason.find(
                  "precondition (forall (?x - thing ?y - thing) (imply (q ?x ?y) (p ?y))) does not hold: "
                  "consider ?x = a, ?y = b (domain.pddl:3:"),
              std::string::npos)
        << verdict.reason;
}

TEST(Validate, EffectsReadTheStateBefore) {
    const Task task = task_of(
        "(:predicates (on ?x - thing)) (:action flip :effect (forall (?x - thing) (and (when (on "
        "?x) (not (on ?x))) (when (not (on ?x)) (on ?x)))))",
        "(on a)", "(and (not (on a)) (on b) (on c))");
    EXPECT_TRUE(run(task, "(flip)").valid);
    EXPECT_FALSE(run(task, "(flip)(flip)").valid);
    EXPECT_TRUE(run(task, "(flip)(flip)(flip)").valid);
}

TEST(Validate, AnAddWinsOverADelete) {
    const Task task = task_of("(:predicates (p) (q)) (:action go :effect (and (p) (not (p)) (not (q)) (q)))",
                              "", "(and (p) (q))");
    EXPECT_TRUE(run(task, "(go)").valid);
}

constexpr const char* kReach =
    R"((:predicates (edge ?x ?y - thing) (root ?x - thing) (reached ?x - thing) (lost))
(:derived (reached ?x - thing) (or (root ?x) (exists (?y - thing) (and (edge ?y ?x) (reached ?y)))))
(:derived (lost) (exists (?x - thing) (not (reached ?x))))
(:action link :parameters (?x ?y - thing) :precondition (reached ?x) :effect (edge ?x ?y))
(:action cut :parameters (?x ?y - thing) :precondition (edge ?x ?y) :effect (not (edge ?x ?y))))";

TEST(Validate, DerivedPredicatesFollowTheState) {
    const Task task = task_of(kReach, "(root a)", "(not (lost))");
    EXPECT_TRUE(run(task, "(link a b)(link b c)").valid);
    EXPECT_TRUE(run(task, "(link a b)(link b c)(link c b)(cut c b)").valid);
    EXPECT_EQ(run(task, "(link b c)").step, 1U);
    EXPECT_EQ(run(task, "(link a b)(link b c)(link c b)(cut a b)").step, 5U)
        << "a cycle does not support itself";
    EXPECT_EQ(run(task, "(link a b)(cut a b)(link b c)").step, 3U);
}

TEST(Validate, RecursionUnderAUniversalQuantifierReachesItsFixpoint) {
    // A thing is safe if all that it leans on is safe.
    const Task task = task_of(R"((:predicates (leans ?x ?y - thing) (safe ?x - thing))
        (:derived (safe ?x - thing) (forall (?y - thing) (imply (leans ?x ?y) (safe ?y))))
        (:action part :parameters (?x ?y - thing) :effect (not (leans ?x ?y))))",
                              "(leans a b) (leans b c) (leans c a)", "(forall (?x - thing) (safe ?x))");
    EXPECT_FALSE(run(task, "").valid) << "the least fixpoint";
    EXPECT_TRUE(run(task, "(part c a)").valid);
    EXPECT_FALSE(run(task, "(part c b)").valid);
}

TEST(Validate, UnstratifiableAxiomsAreRefused) {
    const Task task = gripper();
    LiftedTask bad = *task;
    bad.predicates[0].derived = true;
    Axiom axiom;
    axiom.predicate = PredicateId(0);
    axiom.scope.variable_types = {TypeId(0), TypeId(0)};
    axiom.scope.variable_names = {"?x", "?y"};
    axiom.scope.parameter_count = 2;
    axiom.body.kind = Connective::negation;
    axiom.body.children.resize(1);
    axiom.body.children[0].kind = Connective::atom;
    axiom.body.children[0].predicate = PredicateId(0);
    axiom.body.children[0].terms = {Term::variable(0), Term::variable(1)};
    bad.axioms.push_back(axiom);
    EXPECT_THROW(validate(bad, {}), UnsupportedError);
}

constexpr const char* kCosts = R"((:predicates (done))
(:functions (price ?x - thing) - number (total-cost) - number)
(:action buy :parameters (?x - thing) :effect (and (done) (increase (total-cost) (price ?x))))
(:action rest :effect (done)))";

TEST(Validate, CostsAreExact) {
    const Task task =
        task_of(kCosts, "(= (price a) 0.1) (= (price b) 1e-1) (= (price c) 3) (= (total-cost) 0)", "(done)",
                "(:metric minimize (total-cost))");
    EXPECT_EQ(run(task, "(buy a)(buy b)(buy a)(rest)").cost, Rational(3, 10));
    EXPECT_EQ(run(task, "(rest)").cost, Rational(0));
}

TEST(Validate, WithoutAMetricStepsCountOne) {
    const Task task =
        task_of(kCosts, "(= (price a) 7) (= (price b) 7) (= (price c) 7) (= (total-cost) 0)", "(done)");
    EXPECT_EQ(run(task, "(buy a)(rest)").cost, Rational(2));
}

TEST(Validate, AnUndefinedCostMakesTheStepInvalid) {
    const Task task =
        task_of(kCosts, "(= (price a) 1) (= (total-cost) 0)", "(done)", "(:metric minimize (total-cost))");
    const Verdict verdict = run(task, "(buy a)(buy b)");
    EXPECT_EQ(verdict.step, 2U);
    EXPECT_NE(verdict.reason.find("(price b), which has no value"), std::string::npos) << verdict.reason;
    EXPECT_EQ(verdict.cost, Rational(1));
}

TEST(Validate, QuantifiersOverAnEmptyType) {
    const std::string domain =
        "(:predicates (p)) (:action all :precondition (forall (?x - nothing) (p)))"
        "(:action some :precondition (exists (?x - nothing) (not (p))))";
    const Task task = task_of(domain, "", "(and)");
    EXPECT_TRUE(run(task, "(all)").valid);
    EXPECT_EQ(run(task, "(some)").step, 1U);
}

TEST(Validate, StepsThatDoNotFitTheTaskAreInvalid) {
    const Task task = gripper();
    Plan plan;
    plan.steps.resize(1);
    EXPECT_EQ(validate(*task, plan).step, 1U);
    plan.steps[0].schema = SchemaId(0);
    EXPECT_NE(validate(*task, plan).reason.find("takes 2 arguments, not 0"), std::string::npos);
    plan.steps[0].arguments = {ObjectId(0), ObjectId(99)};
    EXPECT_NE(validate(*task, plan).reason.find("argument 2 is not an object"), std::string::npos);
}

RC_GTEST_PROP(ValidateProperty, AgreesWithTheTextbook, (std::uint32_t first)) {
    for (std::uint32_t seed = first; seed - first < 50; ++seed) {
        const test::RandomTask random = test::random_task(seed);
        const Verdict verdict = validate(random.task, random.plan);
        RC_ASSERT(verdict.step == test::naive_failure(random.task, random.plan));
        RC_ASSERT(verdict.valid == (verdict.step == 0));
        RC_ASSERT(verdict.reason.empty() == verdict.valid);
    }
}

}  // namespace
}  // namespace praxis
