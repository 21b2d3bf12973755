// From the text of a contingent task to the ground one, construct by construct.
#include <gtest/gtest.h>

#include "belief/worlds.hpp"
#include "parser/diagnostic.hpp"
#include "tests/belief/texts.hpp"

namespace praxis::belief::test {
namespace {

constexpr const char* kLook =
    "(:action look-p :parameters () :observe (p)) (:action look-q :parameters () :observe (q))"
    "(:action win :parameters () :effect (and (when (p) (not (q))) (g)))";

std::string error_of(const Texts& texts) {
    try {
        ground(texts);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

bool uncertain(const BeliefTask& task, const std::string& atom) {
    const Fact fact = fact_of(task, atom);
    return fact.variable >= 0 && task.uncertain[static_cast<std::size_t>(fact.variable)];
}

std::size_t world_count(const Texts& texts) {
    const auto worlds = enumerate_worlds(*ground(texts), 10'000);
    return worlds ? worlds->size() : 0;
}

TEST(GroundBelief, WhatIsNotSaidToBeUnknownIsCertain) {
    const auto task = ground(propositional("(p) (q) (g)", kLook, "(p) (unknown (q))", "(g)"));
    EXPECT_FALSE(uncertain(*task, "(p)"));
    EXPECT_TRUE(uncertain(*task, "(q)"));
    EXPECT_FALSE(uncertain(*task, "(g)"));
}

TEST(GroundBelief, AStatementWinsOverUnknown) {
    const auto task =
        ground(propositional("(p) (q) (g)", kLook, "(p) (unknown (p)) (not (q)) (or (q) (p))", "(g)"));
    EXPECT_FALSE(uncertain(*task, "(p)"));
    EXPECT_FALSE(uncertain(*task, "(q)"));
    EXPECT_EQ(task->clauses.size(), 0u);
}

TEST(GroundBelief, ClausesOfEachKind) {
    const auto count = [](const std::string& init) {
        return world_count(propositional("(p) (q) (r) (g)", kLook, init, "(g)"));
    };
    EXPECT_EQ(count("(unknown (p)) (unknown (q)) (unknown (r))"), 8u);
    EXPECT_EQ(count("(or (p) (q) (r))"), 7u);
    EXPECT_EQ(count("(oneof (p) (q) (r))"), 3u);
    EXPECT_EQ(count("(invariant (p) (not (q)) (r))"), 7u);
    EXPECT_EQ(count("(at-least-one (p) (q))"), 3u);
    EXPECT_EQ(count("(at-most-one (p) (q) (r))"), 4u);
    EXPECT_EQ(count("(exactly-one (p) (q) (r))"), 3u);
    EXPECT_EQ(count("(invariant (p) (not (p)))"), 2u);
    EXPECT_EQ(count("(oneof (p) (q)) (oneof (q) (r))"), 2u);
    EXPECT_EQ(count("(oneof (p))"), 1u);
    EXPECT_EQ(count("(q) (oneof (p) (q) (r))"), 1u);
    EXPECT_EQ(count("(not (q)) (oneof (p) (q))"), 1u);
    EXPECT_EQ(count("(oneof (p) (not (p)) (q))"), 2u);
}

TEST(GroundBelief, OpenWorld) {
    const Texts texts = propositional("(p) (q) (g)", "(:open-world p q)" + std::string(kLook), "(p)", "(g)");
    const auto task = ground(texts);
    EXPECT_FALSE(uncertain(*task, "(p)"));
    EXPECT_TRUE(uncertain(*task, "(q)"));
    EXPECT_EQ(world_count(texts), 2u);
}

TEST(GroundBelief, UncertaintySpreadsThroughConditionsAndAxioms) {
    const auto task = ground(propositional(
        "(p) (q) (r) (s) (d) (g)",
        "(:derived (d) (or (q) (and (d) (r))))"
        "(:action a :parameters () :effect (when (p) (q))) (:action b :parameters () :effect (when (d) (r)))"
        "(:action c :parameters () :effect (s)) (:action f :parameters () :precondition (s) :effect (g))",
        "(unknown (p))", "(and (g) (d))"));
    EXPECT_TRUE(uncertain(*task, "(q)"));
    EXPECT_TRUE(uncertain(*task, "(r)"));
    EXPECT_FALSE(uncertain(*task, "(s)"));
    EXPECT_FALSE(uncertain(*task, "(g)"));
}

TEST(GroundBelief, WhatIsForgottenIsUncertain) {
    const auto task =
        ground({"(define (domain d) (:types thing) (:predicates (up ?x - thing) (g))"
                "(:action shake :parameters (?x - thing) :effect (unknown (up ?x)))"
                "(:action win :parameters (?x - thing) :precondition (not (up ?x)) :effect (g)))",
                "(define (problem p) (:domain d) (:objects a b - thing)"
                "(:init (up a)) (:goal (g)))"});
    EXPECT_TRUE(uncertain(*task, "(up a)"));
    EXPECT_TRUE(uncertain(*task, "(up b)"));
    EXPECT_EQ(enumerate_worlds(*task, 10)->size(), 1u);
    for (const char* thing : {"a", "b"}) {
        const std::uint32_t action = action_of(*task, std::string("(shake ") + thing + ")");
        ASSERT_LT(action, task->operator_count());
        ASSERT_EQ(task->forgotten[action].size(), 1u);
        EXPECT_EQ(task->forgotten[action][0], fact_of(*task, std::string("(up ") + thing + ")").variable);
    }
}

TEST(GroundBelief, ReadingsOfActionsAreGround) {
    const auto task =
        ground({"(define (domain d) (:types thing) (:predicates (in ?x - thing) (big ?x - thing) (g))"
                "(:action look :parameters (?x - thing) :observe (probabilistic 0.8 (in ?x)))"
                "(:action look-all :parameters () :observe (forall (?x - thing) (when (big ?x) (in ?x))))"
                "(:action win :parameters (?x - thing) :precondition (in ?x) :effect (g)))",
                "(define (problem p) (:domain d) (:objects a b c - thing)"
                "(:init (big a) (big c) (oneof (in a) (in b) (in c))) (:goal (g)))"});
    const std::uint32_t look = action_of(*task, "(look b)");
    const std::uint32_t all = action_of(*task, "(look-all)");
    ASSERT_LT(look, task->operator_count());
    ASSERT_LT(all, task->operator_count());
    ASSERT_EQ(task->readings[look].size(), 1u);
    EXPECT_EQ(task->readings[look][0].fact.variable, fact_of(*task, "(in b)").variable);
    EXPECT_DOUBLE_EQ(task->readings[look][0].accuracy, 0.8);
    ASSERT_EQ(task->readings[all].size(), 2u);
    EXPECT_EQ(task->readings[all][0].fact.variable, fact_of(*task, "(in a)").variable);
    EXPECT_EQ(task->readings[all][1].fact.variable, fact_of(*task, "(in c)").variable);
    EXPECT_DOUBLE_EQ(task->readings[all][1].accuracy, 1);
}

TEST(GroundBelief, SensorsAreGroundAndNoOperators) {
    const auto task = ground(
        {"(define (domain d) (:types pos) (:predicates (at ?p - pos) (smelly ?p - pos))"
         "(:action go :parameters (?p ?q - pos) :precondition (at ?p) :effect (and (not (at ?p)) (at ?q)))"
         "(:sensor smell :parameters (?p - pos) :condition (at ?p) :sense (smelly ?p))"
         "(:action clean :parameters (?p - pos) :precondition (smelly ?p) :effect (not (smelly ?p))))",
         "(define (problem p) (:domain d) (:objects a b - pos)"
         "(:init (at a) (unknown (smelly a)) (unknown (smelly b))) (:goal (and (not (smelly a)) (not (smelly "
         "b)))))"});
    ASSERT_EQ(task->sensors.size(), 2u);
    EXPECT_EQ(task->sensors[0].name, "(smell a)");
    EXPECT_EQ(task->sensors[1].name, "(smell b)");
    EXPECT_EQ(task->sensor_conditions.size(), 2u);
    for (std::uint32_t action = 0; action < task->operator_count(); ++action)
        EXPECT_EQ(task->physical->operator_name(OperatorId(action)).find('@'), std::string::npos);
}

TEST(GroundBelief, ContradictoryDescriptionsHaveAPlace) {
    const auto error = [](const std::string& init) {
        return error_of(propositional("(p) (q) (g)", kLook, init, "(g)"));
    };
    for (const char* init : {"(not (p)) (not (q)) (or (p) (q))", "(p) (q) (oneof (p) (q))",
                             "(p) (q) (at-most-one (p) (q))", "(not (p)) (oneof (p))"}) {
        const std::string text = error(init);
        EXPECT_NE(text.find("problem.pddl:2:"), std::string::npos) << init << "\n" << text;
        EXPECT_NE(text.find("no first state satisfies this"), std::string::npos) << init << "\n" << text;
    }
    EXPECT_EQ(error("(unknown (p)) (unknown (q))"), "");
}

TEST(GroundBelief, ADerivedAtomCannotBeSensed) {
    const std::string text =
        error_of(propositional("(p) (d) (g)",
                               "(:derived (d) (or (p) (and (d) (g))))"
                               "(:action look :parameters () :observe (d))"
                               "(:action a :parameters () :precondition (d) :effect (and (g) (not (p))))",
                               "(unknown (p))", "(g)"));
    EXPECT_NE(text.find("domain.pddl:"), std::string::npos) << text;
    EXPECT_NE(text.find("derived predicate"), std::string::npos) << text;
}

TEST(GroundBelief, GoalsOutOfReachAreProvedSo) {
    const auto task = ground(propositional("(p) (q) (g)", "(:action look :parameters () :observe (p))",
                                           "(unknown (p)) (oneof (p) (q))", "(g)"));
    EXPECT_TRUE(task->physical->proved_unsolvable);
}

TEST(GroundBelief, AClassicalTaskHasNoUncertainty) {
    const auto task = ground(
        propositional("(p) (g)", "(:action a :parameters () :precondition (p) :effect (g))", "(p)", "(g)"));
    EXPECT_EQ(task->operator_count(), 1u);
    for (const bool open : task->uncertain) EXPECT_FALSE(open);
    EXPECT_EQ(enumerate_worlds(*task, 10)->size(), 1u);
}

TEST(GroundBelief, ATaskOfNothing) {
    const auto task = ground(propositional("(p)", "", "", "(and)"));
    EXPECT_EQ(task->operator_count(), 0u);
    EXPECT_TRUE(task->physical->goal.empty());
    EXPECT_FALSE(task->physical->proved_unsolvable);
}

TEST(GroundBelief, StopsWhenTheBudgetIsSpent) {
    const Texts texts = propositional("(p) (q) (g)", kLook, "(unknown (p)) (unknown (q))", "(g)");
    const auto source = parse_contingent({"domain.pddl", texts.domain}, {"problem.pddl", texts.problem}).task;
    std::stop_source stop;
    stop.request_stop();
    const GroundBeliefResult result = ground_belief(source, Budget().stop_with(stop.get_token()));
    EXPECT_EQ(result.stop, Stop::interrupted);
    EXPECT_EQ(result.task, nullptr);
}

}  // namespace
}  // namespace praxis::belief::test
