// What came out wrong once, and examples of what grounding promises.
#include "search/ground/ground.hpp"

#include <gtest/gtest.h>

#include <string>

#include "search/session.hpp"
#include "tests/search/ground/equivalence.hpp"
#include "tests/search/ground/texts.hpp"

namespace praxis {
namespace {

using test::task_of;

TEST(Ground, AStaticDerivedPredicateDoesNotHideInitialAtoms) {
    const Task task = task_of(
        "(:predicates (at ?x - thing) (road ?x ?y - thing) (near ?x ?y - thing))"
        "(:derived (near ?x ?y - thing) (or (road ?x ?y) (road ?y ?x)))"
        "(:action go :parameters (?x ?y - thing) :precondition (and (at ?x) (near ?x ?y))"
        " :effect (and (not (at ?x)) (at ?y)))",
        "(at a) (road b a) (road b c)", "(at c)");
    EXPECT_EQ(test::compare(*task, 100).difference, "");
    const auto made = ground(*task).task;
    EXPECT_FALSE(made->proved_unsolvable);
    EXPECT_FALSE(made->has_axioms());
}

TEST(Ground, ConditionsMayBecomeReachableAfterTheirAction) {
    const Task task = task_of(
        "(:predicates (p ?a - thing) (q ?a - thing) (r ?a - thing))"
        "(:action go :parameters (?x - thing) :effect (when (q ?x) (p ?x)))"
        "(:action make :parameters (?x - thing) :precondition (r ?x) :effect (and (q ?x) (not (r ?x))))"
        "(:action back :parameters (?x - thing) :precondition (q ?x) :effect (r ?x))",
        "(r a)", "(p a)");
    EXPECT_EQ(test::compare(*task, 100).difference, "");
    EXPECT_FALSE(ground(*task).task->proved_unsolvable);
}

TEST(Ground, WhatIsAlwaysDerivedIsNoFact) {
    const Task task = task_of(
        "(:predicates (p) (q) (always ?x - thing))"
        "(:derived (always ?x - thing) (or (= ?x a) (p)))"
        "(:action go :effect (p)) (:action undo :effect (not (p))) (:action sit :effect (q))",
        "", "(q)");
    Session session(task);
    const Configuration configuration = praxis::configuration("astar(blind())");
    EXPECT_TRUE(session.plan(configuration).plan);
    const auto always = PredicateId(2);
    session.set_goal({{{always, {ObjectId(0)}}, false}});
    const Result result = session.plan(configuration);
    ASSERT_TRUE(result.plan);
    EXPECT_TRUE(result.plan->steps.empty());
    session.set_goal({{{always, {ObjectId(1)}}, false}});
    EXPECT_TRUE(session.plan(configuration).plan);
}

}  // namespace
}  // namespace praxis
