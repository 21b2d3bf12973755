// Plans of the lifted search, checked by the independent validator, and proofs that there is none.
#include "search/lifted/lifted_search.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <stop_token>
#include <string>

#include "parser/parser.hpp"
#include "search/validate.hpp"
#include "tests/search/ground/moving_task.hpp"
#include "tests/search/ground/state_space.hpp"
#include "tests/search/ground/texts.hpp"
#include "tests/search/support/random_task.hpp"

namespace praxis {
namespace {

void expect_plan(const LiftedTask& task, const LiftedOutcome& outcome) {
    ASSERT_EQ(outcome.status, Status::solved);
    ASSERT_TRUE(outcome.plan);
    const Verdict verdict = validate(task, *outcome.plan);
    EXPECT_TRUE(verdict.valid) << verdict.reason;
    EXPECT_EQ(verdict.cost, outcome.plan->cost);
}

/// Solved exactly if the whole space, when it is small enough to see, has a goal state.
void check_against_space(const LiftedTask& task, std::size_t& solvable, std::size_t& unsolvable) {
    const test::LiftedSpace space(task, 300);
    if (!space.distance.complete) return;
    const LiftedOutcome outcome = lifted_search(task);
    if (space.distance.shortest) {
        ++solvable;
        RC_ASSERT(outcome.status == Status::solved);
        const Verdict verdict = validate(task, *outcome.plan);
        RC_ASSERT(verdict.reason == "");
        RC_ASSERT(verdict.valid);
        RC_ASSERT(verdict.cost == outcome.plan->cost);
    } else {
        ++unsolvable;
        RC_ASSERT((outcome.status == Status::unsolvable || outcome.status == Status::unsolvable_early));
        RC_ASSERT(!outcome.plan);
    }
}

constexpr const char* kChain =
    "(:predicates (at ?x - thing) (next ?x ?y - thing))"
    "(:action go :parameters (?x ?y - thing) :precondition (and (at ?x) (next ?x ?y))"
    " :effect (and (at ?y) (not (at ?x))))";

TEST(LiftedSearch, NothingToDo) {
    const Task task = test::task_of(kChain, "(at a)", "(at a)");
    const LiftedOutcome outcome = lifted_search(*task);
    expect_plan(*task, outcome);
    EXPECT_TRUE(outcome.plan->steps.empty());
}

TEST(LiftedSearch, FindsTheWay) {
    const Task task = test::task_of(kChain, "(at a) (next a b) (next b c)", "(at c)");
    const LiftedOutcome outcome = lifted_search(*task);
    expect_plan(*task, outcome);
    EXPECT_EQ(outcome.plan->steps.size(), 2u);
    EXPECT_EQ(outcome.statistics.registered_states, 3u);
}

TEST(LiftedSearch, ProvesThatThereIsNoPlan) {
    const Task task = test::task_of(kChain, "(at a) (next a b) (next b a)", "(at c)");
    EXPECT_EQ(lifted_search(*task).status, Status::unsolvable);
    EXPECT_EQ(lifted_search(*test::task_of(kChain, "(at a)", "(and (at a) (next a b))")).status,
              Status::unsolvable_early);
    EXPECT_EQ(lifted_search(*test::task_of(kChain, "(at a)", "(and (at b) (not (at b)))")).status,
              Status::unsolvable_early);
}

TEST(LiftedSearch, TakesTheCheaperOfTwoActionsWithTheSameChange) {
    const Task task = test::task_of(
        "(:predicates (p)) (:functions (total-cost) (price ?x - thing))"
        "(:action buy :parameters (?x - thing) :precondition () :effect (and (p) (increase (total-cost) "
        "(price ?x))))",
        "(= (total-cost) 0) (= (price a) 7) (= (price b) 2)", "(p)", "(:metric minimize (total-cost))");
    const LiftedOutcome outcome = lifted_search(*task);
    expect_plan(*task, outcome);
    EXPECT_EQ(outcome.plan->cost, Rational(2));
}

/// Twelve parameters over twenty objects: more ground actions than any memory holds.
TEST(LiftedSearch, SolvesWhatCannotBeGrounded) {
    std::string parameters, names, conditions;
    for (int i = 0; i < 12; ++i) parameters += " ?x" + std::to_string(i);
    for (int i = 0; i < 20; ++i) names += "o" + std::to_string(i) + " ";
    for (int i = 0; i + 1 < 12; ++i)
        conditions += " (link ?x" + std::to_string(i) + " ?x" + std::to_string(i + 1) + ")";
    const std::string domain =
        "(:predicates (link ?x ?y - thing) (cut ?x - thing))"
        "(:action tie :parameters (?x ?y - thing) :precondition (not (= ?x ?y))"
        " :effect (link ?x ?y))"
        "(:action cut :parameters (" +
        parameters + " - thing) :precondition (and" + conditions + ") :effect (cut ?x11))";
    std::string init;
    for (int i = 0; i < 10; ++i) init += "(link o" + std::to_string(i) + " o" + std::to_string(i + 1) + ")";
    const Task task = test::task_of(domain, init, "(cut o19)", "", names + "- thing");
    Budget budget;
    budget.limit_wall_time(60);
    expect_plan(*task, lifted_search(*task, budget));
}

TEST(LiftedSearch, StopsWhenTold) {
    const Task task = test::task_of(kChain, "(at a) (next a b) (next b a)", "(at c)");
    Budget spent;
    spent.limit_wall_time(0);
    EXPECT_EQ(lifted_search(*task, spent).status, Status::out_of_time);
    std::stop_source stop;
    stop.request_stop();
    Budget interrupted;
    interrupted.stop_with(stop.get_token());
    EXPECT_EQ(lifted_search(*task, interrupted).status, Status::interrupted);
}

TEST(LiftedSearch, AgreesWithTheWholeSpaceForAnyFormula) {
    std::size_t solvable = 0, unsolvable = 0;
    ASSERT_TRUE(rc::check([&] {
        const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        RC_LOG() << "random_task(" << seed << ")";
        check_against_space(test::random_task(seed).task, solvable, unsolvable);
    }));
    EXPECT_GT(solvable, 0u);
    EXPECT_GT(unsolvable, 0u);
}

TEST(LiftedSearch, AgreesWithTheWholeSpaceWhereThingsMove) {
    std::size_t solvable = 0, unsolvable = 0;
    ASSERT_TRUE(rc::check([&] {
        const auto seed = *rc::gen::noShrink(rc::gen::arbitrary<std::uint32_t>());
        RC_LOG() << "moving_task(" << seed << ")";
        check_against_space(*test::moving_task(seed).task, solvable, unsolvable);
    }));
    EXPECT_GT(solvable, 0u);
}

class OwnDomain : public testing::TestWithParam<const char*> {};

TEST_P(OwnDomain, SmallProblemIsSolvedTheSameWayTwice) {
    const std::string root = PRAXIS_SOURCE_DIR;
    const Task task = load(root + "/domains/" + GetParam() + "/domain.pddl",
                           root + "/problems/" + GetParam() + "/small.pddl");
    const LiftedOutcome first = lifted_search(*task);
    expect_plan(*task, first);
    EXPECT_EQ(first.plan->steps, lifted_search(*task).plan->steps);
}

INSTANTIATE_TEST_SUITE_P(All, OwnDomain,
                         testing::Values("courier", "harbour", "hotel-lift", "household", "kitchen", "lights",
                                         "tiles", "warehouse", "water-network"),
                         [](const auto& name) {
                             std::string text = name.param;
                             std::erase(text, '-');
                             return text;
                         });

}  // namespace
}  // namespace praxis
