// Cost-sensitive determinization: plans that assume what is unlikely cost more.
#include <gtest/gtest.h>

#include <string>

#include "belief/knowledge_planner.hpp"

namespace praxis::belief {
namespace {

// A key is in one of six jars; looking into one takes a step. A locksmith takes four steps and needs no luck.
constexpr const char* kDomain = R"(
(define (domain lock) (:types jar) (:predicates (in ?j - jar) (key) (open) (s1) (s2) (s3))
  (:action look :parameters (?j - jar) :observe (in ?j))
  (:action take :parameters (?j - jar) :precondition (in ?j) :effect (key))
  (:action unlock :parameters () :precondition (key) :effect (open))
  (:action call :parameters () :effect (s1))
  (:action wait :parameters () :precondition (s1) :effect (s2))
  (:action pay :parameters () :precondition (s2) :effect (s3))
  (:action let :parameters () :precondition (s3) :effect (open))))";
constexpr const char* kProblem = R"(
(define (problem p) (:domain lock) (:objects a b c d e f - jar)
  (:init (oneof (in a) (in b) (in c) (in d) (in e) (in f))) (:goal (open))))";

std::size_t length_of_plan(double risk) {
    const auto task = ground_belief(parse_contingent({"d", kDomain}, {"p", kProblem}).task).task;
    CompilationOptions options;
    options.risk = risk;
    const auto compilation = std::make_shared<const Compilation>(task, options);
    const KnowledgePlanner planner(compilation);
    const Belief belief(compilation);
    return planner.plan(belief, configuration("astar(blind())"), {}).steps.size();
}

TEST(Risk, WithoutItPlansHopeForTheBest) {
    EXPECT_EQ(length_of_plan(0), 3u);
}  // look, take, unlock
// -log(1/6) is 1.8: the hopeful plan costs 3.9 with half of it, 4.8 with all.
TEST(Risk, ALittleIsTaken) {
    EXPECT_EQ(length_of_plan(0.5), 3u);
}
TEST(Risk, TooMuchIsAvoided) {
    EXPECT_EQ(length_of_plan(1), 4u);
}

}  // namespace
}  // namespace praxis::belief
