// Each construct of the language, from text to task.
#include <gtest/gtest.h>

#include "tests/parser/texts.hpp"

namespace praxis {
namespace {

using test::domain;
using test::empty_problem;
using test::parse;
using test::problem;
using test::warnings_of;

Task task_of(const std::string& domain_text, const std::string& problem_text = empty_problem()) {
    return parse(domain_text, problem_text).task;
}

std::vector<std::string> names_in(const LiftedTask& task, const std::string& type_name) {
    std::vector<std::string> names;
    for (const Type& type : task.types) {
        if (type.name != type_name) continue;
        for (const ObjectId object : type.objects) {
            EXPECT_TRUE(type.contains[object.index()]);
            names.push_back(task.objects[object.index()].name);
        }
    }
    return names;
}

using Names = std::vector<std::string>;

TEST(Types, ObjectComesFirstAndHierarchyHolds) {
    const Task task = task_of(domain("(:types truck car - vehicle vehicle place) (:constants c - car)"),
                              problem("(:objects t - truck p - place o) (:goal ())"));
    EXPECT_EQ(task->types[0].name, "object");
    EXPECT_TRUE(task->types[0].parents.empty());
    EXPECT_EQ(names_in(*task, "object"), (Names{"c", "t", "p", "o"}));
    EXPECT_EQ(names_in(*task, "vehicle"), (Names{"c", "t"}));
    EXPECT_EQ(names_in(*task, "truck"), (Names{"t"}));
    EXPECT_EQ(names_in(*task, "place"), (Names{"p"}));
}

TEST(Types, SupertypesMayBeDeclaredLater) {
    const LoadResult result = parse(domain("(:types a - b b - c c)"), problem("(:objects x - a) (:goal ())"));
    EXPECT_EQ(warnings_of(result), "");
    EXPECT_EQ(names_in(*result.task, "c"), Names{"x"});
}

TEST(Types, SupertypesThatAreNeverDeclaredAreWarnedOf) {
    const LoadResult result = parse(domain("(:types a - b)"), problem("(:objects x - a y - b) (:goal ())"));
    EXPECT_EQ(warnings_of(result),
              "domain.pddl:2:13: warning: type 'b' is used but not declared\n"
              "  2 | (:types a - b))\n"
              "    |             ^ taken as a subtype of 'object'\n");
    EXPECT_EQ(names_in(*result.task, "b"), (Names{"x", "y"}));
}

TEST(Types, DeclaredTwiceHaveAllSupertypes) {
    const LoadResult result =
        parse(domain("(:types b c - object a - object a - b a - c)"), problem("(:objects x - a) (:goal ())"));
    EXPECT_TRUE(test::contains(warnings_of(result), "duplicate type 'a'"));
    EXPECT_EQ(names_in(*result.task, "b"), Names{"x"});
    EXPECT_EQ(names_in(*result.task, "c"), Names{"x"});
}

TEST(Types, EitherInTypesMeansSeveralSupertypes) {
    const Task task =
        task_of(domain("(:types b c - object a - (either b c))"), problem("(:objects x - a) (:goal ())"));
    EXPECT_EQ(names_in(*task, "b"), Names{"x"});
    EXPECT_EQ(names_in(*task, "c"), Names{"x"});
}

TEST(Types, EitherOfParametersIsAnAnonymousUnion) {
    const Task task = task_of(
        domain("(:types v - object a b - v c) (:predicates (p ?x - (either b a)))"
               "(:action act :parameters (?x - (either a b) ?y - (either a a)) :precondition (p ?x))"),
        problem("(:objects x - a y - b z - c) (:init (p x) (p y)) (:goal ())"));
    EXPECT_EQ(names_in(*task, "(either a b)"), (Names{"x", "y"}));
    const Type& either = task->types[task->predicates[0].parameters[0].index()];
    EXPECT_EQ(either.name, "(either a b)");
    ASSERT_EQ(either.parents.size(), 1U);
    EXPECT_EQ(task->types[either.parents[0].index()].name, "v");
    EXPECT_EQ(task->schemas[0].scope.variable_types[0], task->predicates[0].parameters[0]);
    EXPECT_EQ(task->types[task->schemas[0].scope.variable_types[1].index()].name, "a");
}

TEST(Types, EitherOfAnObjectBelongsToAllMembers) {
    const Task task = task_of(domain("(:types a b) (:predicates (p ?x - a) (q ?x - b))"),
                              problem("(:objects o - (either a b)) (:init (p o) (q o)) (:goal ())"));
    EXPECT_EQ(names_in(*task, "a"), Names{"o"});
    EXPECT_EQ(names_in(*task, "b"), Names{"o"});
    EXPECT_EQ(names_in(*task, "(either a b)"), Names{"o"});
}

TEST(Objects, MayRepeatConstants) {
    const LoadResult result = parse(domain("(:types a - object b - a) (:constants k l - a)"),
                                    problem("(:objects k - a l - b) (:goal ())"));
    EXPECT_EQ(result.warnings.size(), 2U);
    EXPECT_EQ(result.task->objects.size(), 2U);
    EXPECT_EQ(names_in(*result.task, "b"), Names{"l"});
}

TEST(Names, IgnoreCase) {
    const Task task = task_of(
        "(DEFINE (Domain D) (:Requirements :ADL) (:Types T) (:PREDICATES (P ?X - t))"
        "(:ACTION A :Parameters (?x - T) :PreCondition (AND (p ?X)) :EFFECT (Not (P ?x))))",
        "(define (problem Q) (:domain d) (:OBJECTS O - T) (:init (P o)) (:goal (p O)))");
    EXPECT_EQ(task->domain_name, "d");
    EXPECT_EQ(task->problem_name, "q");
    EXPECT_EQ(task->objects[0].name, "o");
    EXPECT_EQ(task->schemas[0].name, "a");
    EXPECT_EQ(task->schemas[0].scope.variable_names, Names{"?x"});
    EXPECT_EQ(task->goal.kind, Connective::atom);
}

TEST(Names, OfPredicatesTypesAndObjectsDoNotCollide) {
    const Task task = task_of(
        domain("(:types thing) (:predicates (thing ?x - thing) (at ?x) (assign ?x ?y) (either))"
               "(:action thing :parameters (?thing - thing) :precondition (and (thing ?thing) (either))"
               " :effect (and (assign ?thing thing) (at thing)))"),
        problem("(:objects thing - thing) (:init (thing thing)) (:goal (assign thing thing))"));
    EXPECT_EQ(task->schemas[0].effects.size(), 2U);
}

TEST(Names, AQuestionMarkStartsANewWord) {
    const Task task =
        task_of(domain("(:predicates (p ?x ?y)) (:action a :parameters (?x?y) :precondition (p?x?y))"));
    EXPECT_EQ(task->schemas[0].precondition.terms.size(), 2U);
}

TEST(Sections, StandInAnyOrder) {
    const Task task = task_of(
        "(define (domain d) (:action a :effect (p k) :parameters ()) (:functions (total-cost))"
        "(:predicates (p ?x - t)) (:constants k - t) (:types t) (:requirements :typing :action-costs))",
        "(define (problem p) (:goal (p k)) (:metric minimize (total-cost)) (:init (= (total-cost) 0)) "
        "(:domain d))");
    EXPECT_EQ(task->schemas.size(), 1U);
    EXPECT_TRUE(task->minimize_cost);
}

TEST(Sections, CommentsStandAnywhere) {
    const Task task =
        task_of("; (define\n(;x\ndefine;\n(domain;)\n d)(:predicates;((\n(p)))", empty_problem() + "; end");
    EXPECT_EQ(task->predicates.size(), 1U);
}

TEST(Sections, ByteOrderMarkIsPassedOver) {
    EXPECT_EQ(task_of("\xEF\xBB\xBF" + domain(""))->domain_name, "d");
}

TEST(Actions, NeedNoParts) {
    const Task task =
        task_of(domain("(:action a) (:action b :parameters () :precondition () :effect ())"
                       "(:action c :parameters (?unused) :precondition (and) :effect (and))"));
    ASSERT_EQ(task->schemas.size(), 3U);
    for (const Schema& schema : task->schemas) {
        EXPECT_EQ(schema.precondition.kind, Connective::truth);
        EXPECT_TRUE(schema.effects.empty());
        EXPECT_FALSE(schema.cost);
    }
    EXPECT_EQ(task->schemas[2].scope.parameter_count, 1U);
}

TEST(Conditions, KeepTheirShape) {
    const Task task =
        task_of(domain("(:predicates (p ?x) (q)) (:constants k)"
                       "(:action a :parameters (?x) :precondition (and (or (q) (p ?x)) (not (p k))"
                       " (imply (q) (= ?x k)) (forall (?y ?z) (exists (?u) (p ?u))) (or) (and)))"));
    const Formula& all = task->schemas[0].precondition;
    ASSERT_EQ(all.kind, Connective::conjunction);
    ASSERT_EQ(all.children.size(), 6U);
    EXPECT_EQ(all.children[0].kind, Connective::disjunction);
    EXPECT_EQ(all.children[1].kind, Connective::negation);
    EXPECT_EQ(all.children[1].children[0].terms[0], Term::object(ObjectId(0)));
    EXPECT_EQ(all.children[2].kind, Connective::implication);
    EXPECT_EQ(all.children[2].children[1].kind, Connective::equality);
    EXPECT_EQ(all.children[2].children[1].terms, (std::vector{Term::variable(0), Term::object(ObjectId(0))}));
    EXPECT_EQ(all.children[3].kind, Connective::universal);
    EXPECT_EQ(all.children[3].variables, (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(all.children[3].children[0].kind, Connective::existential);
    EXPECT_EQ(all.children[3].children[0].variables, (std::vector<std::uint32_t>{3}));
    EXPECT_EQ(all.children[4].kind, Connective::falsity);
    EXPECT_EQ(all.children[5].kind, Connective::truth);
    EXPECT_EQ(task->schemas[0].scope.parameter_count, 1U);
    EXPECT_EQ(task->schemas[0].scope.variable_names, (Names{"?x", "?y", "?z", "?u"}));
}

TEST(Conditions, InnerVariablesHideOuterOnes) {
    const LoadResult result =
        parse(domain("(:predicates (p ?x))"
                     "(:action a :parameters (?x) :precondition (and (exists (?x) (p ?x)) (p ?x)))"),
              empty_problem());
    EXPECT_TRUE(test::contains(warnings_of(result), "variable '?x' hides another one"));
    const Formula& all = result.task->schemas[0].precondition;
    EXPECT_EQ(all.children[0].children[0].terms[0], Term::variable(1));
    EXPECT_EQ(all.children[1].terms[0], Term::variable(0));
}

TEST(Effects, AreFlattened) {
    const Task task =
        task_of(domain("(:predicates (p ?x) (q) (r)) (:action a :parameters (?x) :effect"
                       " (and (q) (forall (?y) (and (not (p ?y)) (when (and (p ?x) (q)) (forall (?z)"
                       " (when (r) (p ?z))))))))"));
    const std::vector<Effect>& effects = task->schemas[0].effects;
    ASSERT_EQ(effects.size(), 3U);
    EXPECT_TRUE(effects[0].add);
    EXPECT_TRUE(effects[0].variables.empty());
    EXPECT_EQ(effects[0].condition.kind, Connective::truth);
    EXPECT_FALSE(effects[1].add);
    EXPECT_EQ(effects[1].variables, (std::vector<std::uint32_t>{1}));
    EXPECT_EQ(effects[1].terms[0], Term::variable(1));
    EXPECT_EQ(effects[2].variables, (std::vector<std::uint32_t>{1, 2}));
    ASSERT_EQ(effects[2].condition.kind, Connective::conjunction);
    EXPECT_EQ(effects[2].condition.children[0].kind, Connective::conjunction);
    EXPECT_EQ(effects[2].condition.children[1].kind, Connective::atom);
    EXPECT_TRUE(task->predicates[0].fluent);
    EXPECT_TRUE(task->predicates[1].fluent);
    EXPECT_FALSE(task->predicates[2].fluent);
}

TEST(Axioms, MarkTheirPredicatesDerived) {
    const Task task =
        task_of(domain("(:types t) (:predicates (p ?x - t) (q ?x))"
                       "(:derived (p ?x) (exists (?y) (q ?y))) (:derived (p ?x - t) (q ?x))"));
    ASSERT_EQ(task->axioms.size(), 2U);
    EXPECT_TRUE(task->predicates[0].derived);
    EXPECT_FALSE(task->predicates[1].derived);
    EXPECT_EQ(task->axioms[0].scope.parameter_count, 1U);
    EXPECT_EQ(task->axioms[0].scope.variable_types[0], TypeId(1));
    EXPECT_EQ(task->axioms[0].body.kind, Connective::existential);
}

TEST(Costs, AreExactExpressions) {
    const Task task =
        task_of(domain("(:functions (total-cost) (d ?a ?b) - number (w) - number)"
                       "(:action a :parameters (?x ?y) :effect (and (increase (total-cost)"
                       " (+ 0.1 (* 2 (d ?x ?y)) (- w) (/ 1 3) (- 5 2))) (increase (total-cost) 1)))"
                       "(:action b :effect (increase (total-cost) 2.50))"),
                problem("(:objects x) (:init (= (d x x) 1.25) (= w 3) (= (total-cost) 0))"
                        "(:goal ()) (:metric minimize (total-cost))"));
    const Expression& sum = task->schemas[0].cost.value();
    ASSERT_EQ(sum.kind, Expression::Kind::add);
    ASSERT_EQ(sum.children.size(), 6U);
    EXPECT_EQ(sum.children[0].value, Rational(1, 10));
    EXPECT_EQ(sum.children[1].kind, Expression::Kind::multiply);
    EXPECT_EQ(sum.children[1].children[1].kind, Expression::Kind::function);
    EXPECT_EQ(sum.children[1].children[1].terms, (std::vector{Term::variable(0), Term::variable(1)}));
    EXPECT_EQ(sum.children[2].kind, Expression::Kind::negate);
    EXPECT_EQ(sum.children[3].kind, Expression::Kind::divide);
    EXPECT_EQ(sum.children[4].kind, Expression::Kind::subtract);
    EXPECT_EQ(sum.children[5].value, Rational(1));
    EXPECT_EQ(task->schemas[1].cost->value, Rational(5, 2));
    EXPECT_EQ(task->initial_values[1].values, (std::vector{Rational(5, 4)}));
    EXPECT_EQ(task->initial_values[2].values, (std::vector{Rational(3)}));
}

TEST(Metric, DecidesWhatCostsCount) {
    const std::string costs = domain("(:functions (total-cost))");
    EXPECT_TRUE(task_of(costs, problem("(:goal ()) (:metric minimize (total-cost))"))->minimize_cost);
    EXPECT_TRUE(task_of(costs, problem("(:goal ()) (:metric minimize total-cost)"))->minimize_cost);
    EXPECT_FALSE(task_of(costs, problem("(:goal ())"))->minimize_cost);
    const LoadResult timed = parse(costs, problem("(:goal ()) (:metric minimize (total-time))"));
    EXPECT_FALSE(timed.task->minimize_cost);
    EXPECT_TRUE(test::contains(warnings_of(timed), "each action costs one"));
}

TEST(Metric, TotalCostMayLackItsDeclaration) {
    const LoadResult result =
        parse(domain("(:action a :effect (increase (total-cost) 3))"),
              problem("(:init (= (total-cost) 0)) (:goal ()) (:metric minimize (total-cost))"));
    EXPECT_TRUE(test::contains(warnings_of(result), "'total-cost' is used but not declared"));
    EXPECT_TRUE(result.task->minimize_cost);
    EXPECT_EQ(result.task->functions.size(), 1U);
    EXPECT_EQ(result.task->initial_values[0].values.size(), 1U);
}

TEST(InitialState, HasNoDuplicates) {
    const Task task =
        task_of(domain("(:predicates (p ?x ?y) (q))"),
                problem("(:objects a b) (:init (p a b) (p b a) (P A B) (q) (q) (not (p a a)) (and (p b b)))"
                        "(:goal ())"));
    EXPECT_EQ(task->initial_atoms[0].count, 3U);
    EXPECT_EQ(task->initial_atoms[0].arity, 2U);
    EXPECT_EQ(task->initial_atoms[0].tuple(1)[0], ObjectId(1));
    EXPECT_EQ(task->initial_atoms[1].count, 1U);
    EXPECT_TRUE(task->initial_atoms[1].arguments.empty());
}

TEST(InitialState, MayBeLarge) {
    std::string objects;
    std::string atoms;
    for (int i = 0; i < 300; ++i) {
        objects += " o" + std::to_string(i);
        for (int j = 0; j < 100; ++j) atoms += "(p o" + std::to_string(i) + " o" + std::to_string(j) + ")";
    }
    const Task task = task_of(domain("(:predicates (p ?x ?y))"),
                              problem("(:objects" + objects + ") (:init" + atoms + atoms + ") (:goal ())"));
    EXPECT_EQ(task->initial_atoms[0].count, 30000U);
    EXPECT_EQ(task->initial_atoms[0].tuple(29999)[0], ObjectId(299));
    EXPECT_EQ(task->initial_atoms[0].tuple(29999)[1], ObjectId(99));
}

TEST(Goal, OwnsItsVariables) {
    const Task task =
        task_of(domain("(:predicates (p ?x))"), problem("(:goal (forall (?a ?b) (imply (p ?a) (p ?b))))"));
    EXPECT_EQ(task->goal.kind, Connective::universal);
    EXPECT_EQ(task->goal_scope.parameter_count, 0U);
    EXPECT_EQ(task->goal_scope.variable_names, (Names{"?a", "?b"}));
}

TEST(Places, PointIntoTheSources) {
    const Task task = task_of(domain("(:action act)"));
    const Location where = task->schemas[0].where;
    EXPECT_EQ(task->sources->files[where.file].text.substr(where.offset, where.length), "act");
}

TEST(Unsupported, FlagsAloneAreNoError) {
    const LoadResult result = parse(
        "(define (domain d) (:requirements :durative-actions :fluents :preferences :constraints"
        " :timed-initial-literals :object-fluents :typing) (:types t) (:functions (f) - t (g) - number))",
        empty_problem());
    EXPECT_EQ(warnings_of(result), "");
}

}  // namespace
}  // namespace praxis
