// Grounding ends when its budget does.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include "search/ground/ground.hpp"
#include "tests/search/ground/texts.hpp"

namespace praxis {
namespace {

constexpr int kObjects = 60;

std::string many_objects() {
    std::string objects;
    for (int i = 0; i < kObjects; ++i) objects += "o" + std::to_string(i) + " ";
    return objects + "- thing";
}

/// 60^8 instances.
Task wide_action() {
    return test::task_of(
        "(:predicates (p ?x - thing) (done))"
        "(:action go :parameters (?a ?b ?c ?d ?e ?f ?g ?h - thing) :effect (and (p ?a) (p ?h) (done)))",
        "", "(done)", "", many_objects());
}

/// 60^8 ways for one condition to hold.
Task wide_condition() {
    std::string variables;
    for (const char* name : {"?a", "?b", "?c", "?d", "?e", "?f", "?g", "?h"})
        variables += std::string(name) + " ";
    return test::task_of(
        "(:predicates (p ?x ?y - thing) (done))"
        "(:action set :parameters (?x ?y - thing) :effect (p ?x ?y))"
        "(:action go :precondition (forall (" +
            variables +
            "- thing) (or (not (p ?a ?b)) (not (p ?b ?c)) (not (p ?c ?d)) (not (p ?d ?e)) "
            "(not (p ?e ?f)) (not (p ?f ?g)) (not (p ?g ?h)))) :effect (done))"
            "(:action undo :parameters (?x ?y - thing) :effect (not (p ?x ?y)))",
        "", "(done)", "", many_objects());
}

double seconds_of(const LiftedTask& task, const Budget& budget, Stop expected) {
    const auto start = std::chrono::steady_clock::now();
    const GroundResult result = ground(task, {}, budget);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(result.stop, expected);
    EXPECT_EQ(result.task, nullptr);
    return elapsed.count();
}

#ifdef PRAXIS_SANITIZED
constexpr double kSlack = 2;
#else
constexpr double kSlack = 0.1;
#endif

/// The best of several, since other processes may be in the way.
void expect_wall_time(const Task& task) {
    constexpr double kLimit = 0.3;
    double best = 10;
    for (int i = 0; i < 8 && best >= kLimit + kSlack; ++i) {
        Budget budget;
        budget.limit_wall_time(kLimit);
        best = std::min(best, seconds_of(*task, budget, Stop::time));
    }
    EXPECT_GE(best, kLimit);
    EXPECT_LT(best, kLimit + kSlack);
}

TEST(GroundBudget, WallTimeOfAWideAction) {
    expect_wall_time(wide_action());
}

TEST(GroundBudget, WallTimeOfAWideCondition) {
    expect_wall_time(wide_condition());
}

TEST(GroundBudget, Memory) {
    constexpr std::size_t kAllowance = std::size_t{200} << 20;
    Budget budget;
    const std::size_t limit = resident_memory() + kAllowance;
    budget.limit_memory(limit);
    EXPECT_LT(seconds_of(*wide_action(), budget, Stop::memory), 60);
    EXPECT_LT(peak_memory(), limit + kAllowance + kAllowance / 2);
}

TEST(GroundBudget, StopToken) {
    std::stop_source source;
    Budget budget;
    budget.stop_with(source.get_token());
    std::jthread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        source.request_stop();
    });
    EXPECT_LT(seconds_of(*wide_action(), budget, Stop::interrupted), 0.4 + kSlack);
}

TEST(GroundBudget, AlreadySpent) {
    Budget budget;
    budget.limit_wall_time(0);
    EXPECT_LT(seconds_of(*wide_action(), budget, Stop::time), kSlack);
}

}  // namespace
}  // namespace praxis
