#include "search/plan.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <random>

#include "parser/parser.hpp"

namespace praxis {
namespace {

constexpr const char* kDomain = R"((define (domain ferry)
  (:requirements :typing :action-costs)
  (:types car place)
  (:predicates (at ?c - car ?p - place) (here ?p - place) (on ?c - car) (empty))
  (:functions (total-cost) - number)
  (:action sail :parameters (?from ?to - place) :precondition (here ?from)
    :effect (and (not (here ?from)) (here ?to) (increase (total-cost) 2.5)))
  (:action board :parameters (?c - car ?p - place) :precondition (and (here ?p) (at ?c ?p) (empty))
    :effect (and (not (at ?c ?p)) (not (empty)) (on ?c)))
  (:action wait :parameters () :effect (and))))";

Task ferry(bool metric = true) {
    const std::string problem = std::string(R"((define (problem f) (:domain ferry)
      (:objects beetle mini - car left right - place)
      (:init (here left) (at beetle left) (at mini right) (empty) (= (total-cost) 0)) (:goal (on mini)))") +
                                (metric ? "(:metric minimize (total-cost)))" : ")");
    return parse_task({"domain.pddl", kDomain}, {"problem.pddl", problem}).task;
}

ParsedPlan read(const std::string& text, const Task& task) {
    return parse_plan({"plan.txt", text}, *task);
}

std::string error_of(const std::string& text, const Task& task) {
    try {
        read(text, task);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Plan, IsWrittenInIpcFormat) {
    const Task task = ferry();
    Plan plan = read("(sail left right)(board mini right)(wait)", task).plan;
    plan.cost = Rational(5, 2);
    EXPECT_EQ(to_string(plan, *task),
              "(sail left right)\n(board mini right)\n(wait)\n; cost = 2.5 (general cost)\n; Cost: 2.5\n");
    plan.cost = Rational(3);
    EXPECT_EQ(to_string(plan, *ferry(false)),
              "(sail left right)\n(board mini right)\n(wait)\n; cost = 3 (unit cost)\n; Cost: 3\n");
}

TEST(Plan, CaseCommentsAndBlanksAreFree) {
    const Task task = ferry();
    const ParsedPlan parsed = read("; a plan\r\n( SAIL Left ; over\n\tRIGHT )(Wait);(board\n", task);
    ASSERT_EQ(parsed.plan.steps.size(), 2U);
    EXPECT_EQ(parsed.plan.steps, read("(sail left right)\n(wait)", task).plan.steps);
    EXPECT_FALSE(parsed.cost_claimed);
    EXPECT_TRUE(read("", task).plan.steps.empty());
}

TEST(Plan, NumbersTimesAndDurationsOfOtherToolsAreAccepted) {
    const Task task = ferry();
    const std::vector<PlanStep> plain = read("(sail left right)\n(board mini right)", task).plan.steps;
    EXPECT_EQ(read("0: (sail left right)\n1: (board mini right)\n", task).plan.steps, plain);
    EXPECT_EQ(read("0.000: (sail left right) [1.000]\n1.000 : (board mini right)[1]", task).plan.steps,
              plain);
}

TEST(Plan, TheClaimedCostIsRead) {
    const Task task = ferry();
    EXPECT_EQ(read("(wait)\n; cost = 12 (unit cost)\n", task).plan.cost, Rational(12));
    EXPECT_EQ(read("; Cost: 2.50\n", task).plan.cost, Rational(5, 2));
    EXPECT_EQ(read(";; COST = 7/3\n", task).plan.cost, Rational(7, 3));
    EXPECT_TRUE(read("; cost = 0 (general cost)", task).cost_claimed);
    for (const char* text :
         {"; costs = 3", "; cost 3", "; cost = many", "; cost = 1/0", "; cost =", "; cost"}) {
        EXPECT_FALSE(read(text, task).cost_claimed) << text;
    }
}

TEST(Plan, ErrorsNameThePlaceAndTheMend) {
    const Task task = ferry();
    const std::string action = error_of("(wait)\n  (bord mini right)\n", task);
    EXPECT_NE(action.find("plan.txt:2:4: error: unknown action 'bord'"), std::string::npos) << action;
    EXPECT_NE(action.find("did you mean 'board'?"), std::string::npos) << action;
    const std::string object = error_of("(board minj right)\n", task);
    EXPECT_NE(object.find("plan.txt:1:8: error: unknown object 'minj'"), std::string::npos) << object;
    EXPECT_NE(object.find("did you mean 'mini'?"), std::string::npos) << object;
    EXPECT_NE(error_of("(board mini)", task).find("takes 2 arguments, not 1"), std::string::npos);
    const std::string type = error_of("(board left right)", task);
    EXPECT_NE(type.find("object 'left' is of type 'place', but parameter ?c of 'board' is of type 'car'"),
              std::string::npos)
        << type;
    EXPECT_NE(error_of("(wait", task).find("not closed"), std::string::npos);
    EXPECT_NE(error_of("(wait (wait)", task).find("not closed before the next"), std::string::npos);
    EXPECT_NE(error_of("()", task).find("needs the name of an action"), std::string::npos);
    EXPECT_NE(error_of("wait", task).find("expected a step"), std::string::npos);
    EXPECT_NE(error_of("(wait))", task).find("expected a step"), std::string::npos);
    EXPECT_NE(error_of("2: (wait) 1: (wait)", task).find("not in the order"), std::string::npos);
}

TEST(Plan, SeveralErrorsAreReportedInOrder) {
    const std::string text = error_of("(sial left right)\n(wait)\n(board mini rihgt)\n", ferry());
    const std::size_t first = text.find("plan.txt:1:2");
    const std::size_t second = text.find("plan.txt:3:13");
    ASSERT_NE(first, std::string::npos) << text;
    ASSERT_NE(second, std::string::npos) << text;
    EXPECT_LT(first, second);
}

TEST(Plan, HostileTextIsAnErrorAndNotACrash) {
    const Task task = ferry();
    EXPECT_NE(error_of(std::string(1 << 20, '('), task), "no error");
    EXPECT_NE(error_of("(" + std::string(1 << 20, 'a') + ")", task), "no error");
    EXPECT_NE(error_of(std::string(1 << 20, ')'), task), "no error");
    EXPECT_NE(error_of(std::string("(wait\0)", 7), task), "no error");
    std::string many;
    for (int i = 0; i < 100000; ++i) many += "(sail left right)\n";
    EXPECT_EQ(read(many, task).plan.steps.size(), 100000U);
}

RC_GTEST_PROP(PlanProperty, WhatIsWrittenIsReadBack, (std::uint32_t seed)) {
    static const Task task = ferry();
    std::mt19937 random(seed);
    Plan plan;
    const std::size_t steps = random() % 8;
    for (std::size_t i = 0; i < steps; ++i) {
        PlanStep step;
        step.schema = SchemaId(random() % task->schemas.size());
        const Scope& scope = task->schemas[step.schema.index()].scope;
        for (std::uint32_t p = 0; p < scope.parameter_count; ++p) {
            const auto& objects = task->types[scope.variable_types[p].index()].objects;
            step.arguments.push_back(objects[random() % objects.size()]);
        }
        plan.steps.push_back(step);
    }
    plan.cost =
        Rational(static_cast<std::int64_t>(random() % 1000), 1 + static_cast<std::int64_t>(random() % 9));
    const ParsedPlan parsed = parse_plan({"plan", to_string(plan, *task)}, *task);
    RC_ASSERT(parsed.plan.steps == plan.steps);
    RC_ASSERT(parsed.cost_claimed);
    RC_ASSERT(parsed.plan.cost == plan.cost);
}

RC_GTEST_PROP(PlanProperty, AnyTextIsAPlanOrAnInputError, (std::uint32_t seed)) {
    static const Task task = ferry();
    static const std::string pieces[] = {"(",   ")",    "sail", "left", "right", "board",   "mini",
                                         " ",   "\n",   ";",    "0:",   "[1]",   "]",       "[",
                                         "1.5", "wait", "\t",   ":",    "x",     "cost = 4"};
    std::mt19937 random(seed);
    std::string text;
    for (std::size_t i = random() % 40; i > 0; --i) text += pieces[random() % std::size(pieces)];
    try {
        const ParsedPlan parsed = parse_plan({"plan", text}, *task);
        for (const PlanStep& step : parsed.plan.steps) {
            RC_ASSERT(step.arguments.size() == task->schemas[step.schema.index()].scope.parameter_count);
            RC_ASSERT(step.where.offset + step.where.length <= text.size());
        }
    } catch (const InputError& error) {
        RC_ASSERT(!error.diagnostics().empty());
        RC_ASSERT(!std::string(error.what()).empty());
    }
}

}  // namespace
}  // namespace praxis
