// Examples of what grounding promises: no blow-up, costs, refusals, variables.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "parser/diagnostic.hpp"
#include "search/ground/ground.hpp"
#include "tests/search/ground/equivalence.hpp"
#include "tests/search/ground/texts.hpp"

namespace praxis {
namespace {

using test::task_of;

std::shared_ptr<const FiniteDomainTask> grounded(const Task& task, bool prune = false) {
    GroundOptions options;
    options.prune_irrelevant = prune;
    return ground(*task, options).task;
}

std::size_t instances_of(const FiniteDomainTask& task, const std::string& name) {
    std::size_t count = 0;
    for (std::size_t o = 0; o < task.operator_count(); ++o) {
        const std::string words = task.operator_names.words(o);
        count += words == name || words.starts_with(name + " ");
    }
    return count;
}

std::string refusal(const Task& task) {
    try {
        ground(*task);
    } catch (const UnsupportedError& error) {
        EXPECT_EQ(error.diagnostics().size(), 1U);
        return error.what();
    }
    return "not refused";
}

/// Twenty switches, and an action under a condition over them.
Task switches(const std::string& condition) {
    std::string objects;
    for (int i = 0; i < 20; ++i) objects += "s" + std::to_string(i) + " ";
    return task_of(
        "(:predicates (on ?x - thing) (done))"
        "(:action set :parameters (?x - thing) :effect (on ?x))"
        "(:action reset :parameters (?x - thing) :effect (not (on ?x)))"
        "(:action go :precondition " +
            condition + " :effect (done))",
        "(on s7)", "(done)", "", objects + "- thing");
}

TEST(GroundExamples, ALongDisjunctionBecomesAnAxiom) {
    std::string condition = "(or";
    for (int i = 0; i < 20; ++i) condition += " (not (on s" + std::to_string(i) + "))";
    const Task task = switches(condition + ")");
    const auto made = grounded(task);
    EXPECT_EQ(instances_of(*made, "go"), 1U);
    EXPECT_EQ(made->axioms.size(), 20U);
    EXPECT_EQ(test::compare(*task, 30).difference, "");
}

TEST(GroundExamples, AProductOfDisjunctionsDoesNotMultiplyOperators) {
    std::string condition = "(and";
    for (int i = 0; i < 20; i += 2)
        condition += " (or (on s" + std::to_string(i) + ") (on s" + std::to_string(i + 1) + "))";
    const Task task = switches(condition + ")");
    const auto made = grounded(task);
    EXPECT_LE(instances_of(*made, "go"), 16U);
    EXPECT_LE(made->axioms.size(), 20U);
    EXPECT_EQ(test::compare(*task, 30).difference, "");
}

TEST(GroundExamples, AUniversalConditionOverManyObjectsIsAConjunction) {
    std::string objects;
    for (int i = 0; i < 200; ++i) objects += "s" + std::to_string(i) + " ";
    const Task task = task_of(
        "(:predicates (on ?x - thing) (done))"
        "(:action set :parameters (?x - thing) :effect (on ?x))"
        "(:action go :precondition (forall (?x - thing) (on ?x)) :effect (done))",
        "", "(done)", "", objects + "- thing");
    const auto made = grounded(task);
    ASSERT_EQ(instances_of(*made, "go"), 1U);
    ASSERT_EQ(made->operator_count(), 201U);
    std::size_t longest = 0;
    for (std::size_t o = 0; o < made->operator_count(); ++o)
        longest = std::max(longest, made->preconditions[o].size());
    EXPECT_EQ(longest, 200U);
    EXPECT_FALSE(made->has_axioms());
    EXPECT_EQ(test::compare(*task, 3).difference, "");
}

TEST(GroundExamples, AnInvariantCountsForEachObjectByItself) {
    // a is in two places, so whoever requires that may happen and put b in a second place.
    const Task task = task_of(
        "(:types place)(:predicates (at ?x - thing ?p - place))"
        "(:action move :parameters (?x - thing ?p ?r - place) :precondition (at ?x ?p)"
        " :effect (and (not (at ?x ?p)) (at ?x ?r)))"
        "(:action both :parameters (?x ?y - thing ?p ?r - place)"
        " :precondition (and (at ?x ?p) (at ?x ?r) (not (= ?p ?r))) :effect (at ?y ?r))",
        "(at a p) (at a q) (at b p)", "(and (at b p) (at b q))", "", "a b - thing p q r - place");
    const test::Equivalence result = test::compare(*task, 1000);
    EXPECT_EQ(result.difference, "");
    EXPECT_TRUE(result.complete);
    EXPECT_TRUE(result.solvable);
}

constexpr const char* kRobot =
    "(:predicates (at ?x - thing) (clean ?x - thing))"
    "(:action move :parameters (?x ?y - thing) :precondition (at ?x) :effect (and (not (at ?x)) (at ?y)))";

TEST(GroundExamples, MovingThingsBecomeOneVariable) {
    const auto made = grounded(task_of(kRobot, "(at a)", "(at c)"));
    ASSERT_EQ(made->variable_count(), 1U);
    EXPECT_EQ(made->domain_sizes[0], 3) << "always somewhere: no value for none of those";
}

TEST(GroundExamples, ANegatedValueGetsAVariableOfItsOwn) {
    const Task task = task_of(std::string(kRobot) +
                                  "(:action wash :parameters (?x - thing) :precondition (not (at ?x))"
                                  " :effect (clean ?x))",
                              "(at a)", "(forall (?x - thing) (clean ?x))");
    const test::Equivalence result = test::compare(*task, 1000);
    EXPECT_EQ(result.difference, "");
    EXPECT_TRUE(result.complete && result.solvable && result.multi_valued && result.shadowed);
    EXPECT_EQ(instances_of(*grounded(task), "wash"), 3U);
}

TEST(GroundExamples, WhatDoesNotMatterIsLeftOut) {
    const Task task = task_of(std::string(kRobot) +
                                  "(:action wash :parameters (?x - thing) :precondition (at ?x)"
                                  " :effect (clean ?x))",
                              "(at a)", "(at c)");
    EXPECT_EQ(grounded(task, true)->variable_count(), 1U);
    EXPECT_EQ(grounded(task, true)->operator_count(), 6U);
    EXPECT_EQ(grounded(task)->variable_count(), 4U);
    EXPECT_EQ(grounded(task)->operator_count(), 9U);
}

TEST(GroundExamples, UnreachableGoalsAreProvedUnsolvable) {
    EXPECT_FALSE(grounded(task_of(kRobot, "(at a)", "(at c)"))->proved_unsolvable);
    for (const char* goal : {"(clean a)", "(and (at a) (at b))", "(not (or (at a) (not (at a))))"}) {
        const auto made = grounded(task_of(kRobot, "(at a)", goal));
        EXPECT_TRUE(made->proved_unsolvable) << goal;
        ASSERT_EQ(made->goal.size(), 1U);
        EXPECT_NE(made->initial_values[0], made->goal[0].value);
    }
    EXPECT_TRUE(grounded(task_of(kRobot, "", "(at a)"))->proved_unsolvable);
}

/// Buying things, at prices.
Task shop(const std::string& prices, const std::string& cost = "(price ?x)", bool metric = true) {
    return task_of(
        "(:predicates (have ?x - thing)) (:functions (price ?x - thing) - number (total-cost) - "
        "number)\n(:action buy :parameters (?x - thing)\n:effect (and (have ?x) (increase "
        "(total-cost) " +
            cost + ")))",
        prices + " (= (total-cost) 0)", "(exists (?x - thing) (have ?x))",
        metric ? "(:metric minimize (total-cost))" : "");
}

TEST(GroundExamples, RationalCostsGetACommonDenominator) {
    const auto made = grounded(shop("(= (price a) 0.5) (= (price b) 1.25) (= (price c) 3)"));
    EXPECT_EQ(made->cost_scale, 4);
    ASSERT_EQ(made->operator_count(), 3U);
    for (std::size_t o = 0; o < 3; ++o) {
        const std::string name = made->operator_names.words(o);
        EXPECT_EQ(made->costs[o], name == "buy a" ? 2 : name == "buy b" ? 5 : 12) << name;
    }
    EXPECT_FALSE(made->unit_cost);
}

TEST(GroundExamples, ThirdsToo) {
    const auto made = grounded(shop("(= (price a) 1) (= (price b) 2) (= (price c) 3)", "(/ (price ?x) 6)"));
    EXPECT_EQ(made->cost_scale, 6);
    EXPECT_EQ(*std::max_element(made->costs.begin(), made->costs.end()), 3);
}

TEST(GroundExamples, WithoutAMetricEachActionCostsOne) {
    const auto made = grounded(shop("(= (price a) 5) (= (price b) 7) (= (price c) 9)", "(price ?x)", false));
    EXPECT_TRUE(made->unit_cost);
    EXPECT_EQ(made->cost_scale, 1);
    EXPECT_EQ(*std::max_element(made->costs.begin(), made->costs.end()), 1);
}

TEST(GroundExamples, AnActionWithoutACostIsNoAction) {
    const auto made = grounded(shop("(= (price a) 5) (= (price c) 9)"));
    EXPECT_EQ(made->operator_count(), 2U);
    EXPECT_EQ(instances_of(*made, "buy"), 2U);
    EXPECT_TRUE(grounded(shop(""))->proved_unsolvable || grounded(shop(""))->operator_count() == 0);
}

TEST(GroundExamples, CostsThatCannotBeUsedAreRefusedWithTheirPlace) {
    const std::string negative =
        refusal(shop("(= (price a) 1) (= (price b) 2) (= (price c) 3)", "(- (price ?x) 2)"));
    EXPECT_NE(negative.find("domain.pddl:5:"), std::string::npos) << negative;
    EXPECT_NE(negative.find("negative"), std::string::npos) << negative;
    const std::string large = refusal(shop("(= (price a) 1) (= (price b) 2000000000) (= (price c) 3)"));
    EXPECT_NE(large.find("domain.pddl:5:"), std::string::npos) << large;
    EXPECT_NE(large.find("2000000000"), std::string::npos) << large;
    const std::string fine = refusal(shop("(= (price a) 0.000001) (= (price b) 1000000) (= (price c) 3)"));
    EXPECT_NE(fine.find("larger"), std::string::npos) << fine;
    const std::string product = refusal(shop("(= (price a) 4000000000) (= (price b) 1) (= (price c) 3)",
                                             "(* (price ?x) (* (price ?x) (price ?x)))"));
    EXPECT_NE(product.find("does not fit"), std::string::npos) << product;
    const std::string quotient =
        refusal(shop("(= (price a) 0) (= (price b) 1) (= (price c) 3)", "(/ 1 (price ?x))"));
    EXPECT_NE(quotient.find("divides by zero"), std::string::npos) << quotient;
}

TEST(GroundExamples, AxiomsThatDependOnTheirOwnNegationAreRefused) {
    const Task task = task_of(
        "(:predicates (p) (q) (r)) (:derived (q) (and (p) (not (r))))"
        "(:derived (r) (and (p) (not (q)))) (:action go :effect (p))"
        "(:action undo :effect (not (p)))",
        "", "(q)");
    EXPECT_NE(refusal(task).find("negation"), std::string::npos);
}

}  // namespace
}  // namespace praxis
