// Facts and values that a refined plan claims, and those that do not follow.
#include "tamp/validate/completed_task.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace praxis::tamp {
namespace {

constexpr const char* kDomain = R"(
(define (domain cups)
  (:requirements :typing :action-costs)
  (:types cup shelf height)
  (:predicates (on ?s - shelf ?h - height) (reachable ?h - height)
               (in-hand ?c - cup) (stored ?c - cup ?s - shelf))
  (:functions (total-cost))
  (:action put :parameters (?c - cup ?s - shelf ?h - height)
    :precondition (and (in-hand ?c) (on ?s ?h) (reachable ?h))
    :effect (and (not (in-hand ?c)) (stored ?c ?s) (increase (total-cost) 1))))
)";
constexpr const char* kProblem = R"(
(define (problem store) (:domain cups) (:objects c - cup low high - shelf)
  (:init (in-hand c) (= (total-cost) 0)) (:goal (stored c low)) (:metric minimize (total-cost)))
)";
constexpr const char* kStreams = R"(
(define (stream cups)
  (:stream sample-height :inputs (?s - shelf) :outputs (?h - height) :certified (on ?s ?h))
  (:stream test-reach :inputs (?s - shelf ?h - height) :domain (on ?s ?h) :certified (reachable ?h)))
)";

class Completed : public testing::Test {
  protected:
    Completed() {
        plan.facts.push_back({StreamId(0), {low}, {height}});
        plan.facts.push_back({StreamId(1), {low, height}, {}});
        plan.steps.push_back({"put", {cup, low, height}});
    }

    std::string fault() const {
        try {
            complete(task, plan);
        } catch (const IncompletePlan& error) {
            return error.what();
        }
        return "none";
    }

    static Value object(const std::string& name) { return Value().named(name); }

    StreamTask task =
        parse_streams({"domain.pddl", kDomain}, {"problem.pddl", kProblem}, {"streams.pddl", kStreams}).task;
    Value cup = object("c");
    Value low = object("low");
    Value height = Value::of(1.0).named("#h");
    RefinedPlan plan;
};

TEST_F(Completed, ValuesBecomeObjectsAndFactsAtoms) {
    const CompletedTask completed = complete(task, plan);
    ASSERT_EQ(completed.task.objects.size(), 4U);
    EXPECT_EQ(completed.task.objects.back().name, "#h");
    EXPECT_EQ(completed.values.back().get<double>(), 1.0);
    ASSERT_EQ(completed.certified.size(), 2U);
    const auto name = [&](std::size_t i) {
        return completed.task.predicates[completed.certified[i].first.index()].name;
    };
    EXPECT_EQ(name(0), "on");
    EXPECT_EQ(name(1), "reachable");
    ASSERT_EQ(completed.plan.steps.size(), 1U);
    EXPECT_EQ(completed.plan.steps[0].arguments.back(), ObjectId(3));
    EXPECT_FALSE(completed.task.minimize_cost);
    const Type& type = *std::ranges::find(completed.task.types, std::string("height"), &Type::name);
    EXPECT_EQ(type.objects, std::vector<ObjectId>{ObjectId(3)});
    EXPECT_TRUE(type.contains[3]);
    EXPECT_FALSE(type.contains[0]);
}

TEST_F(Completed, FactsMayComeInAnyOrder) {
    std::ranges::reverse(plan.facts);
    EXPECT_EQ(fault(), "none");
}

TEST_F(Completed, TheSameFactTwiceIsOne) {
    plan.facts.push_back(plan.facts[1]);
    EXPECT_EQ(complete(task, plan).certified.size(), 2U);
}

TEST_F(Completed, DomainsMustHold) {
    plan.facts[1].inputs[0] = object("high");
    EXPECT_EQ(fault(), "the domain of stream 'test-reach' does not hold where it is used");
}

TEST_F(Completed, AFactDoesNotRestOnItself) {
    plan.facts[0] = {StreamId(1), {low, height}, {}};
    EXPECT_EQ(fault(), "stream 'test-reach' uses '#h', which no stream has made");
}

TEST_F(Completed, InputsHaveTheirTypes) {
    plan.facts[0].inputs[0] = cup;
    EXPECT_EQ(fault(), "stream 'sample-height' is used with 'c', which is no shelf");
}

TEST_F(Completed, ValuesAreMadeOnce) {
    plan.facts.push_back({StreamId(0), {object("high")}, {height}});
    EXPECT_EQ(fault(), "'#h' was made twice");
    plan.facts.back().outputs[0] = Value::of(2.0).named("low");
    EXPECT_EQ(fault(), "'low' was made twice");
}

TEST_F(Completed, NamesStandForOneValue) {
    plan.steps[0].arguments[2] = Value::of(1.0).named("#h");
    EXPECT_EQ(fault(), "'#h' stands for two values");
}

TEST_F(Completed, StreamsHaveTheInputsThatAreDeclared) {
    plan.facts[0].inputs.push_back(cup);
    EXPECT_EQ(fault(), "stream 'sample-height' has other inputs and outputs");
    plan.facts[0].inputs.pop_back();
    plan.facts[1].outputs.push_back(Value::of(2.0).named("#h2"));
    EXPECT_EQ(fault(), "stream 'test-reach' has other inputs and outputs");
    plan.facts[1] = {StreamId(7), {}, {}};
    EXPECT_EQ(fault(), "there is no stream number 7");
}

TEST_F(Completed, StepsUseWhatThereIs) {
    plan.steps[0].arguments[0] = object("mug");
    EXPECT_EQ(fault(), "action 'put' uses 'mug', which no stream has made");
    plan.steps[0].name = "throw";
    EXPECT_EQ(fault(), "there is no action 'throw'");
}

}  // namespace
}  // namespace praxis::tamp
