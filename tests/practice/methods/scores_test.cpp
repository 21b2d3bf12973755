// Scores against those computed by hand. A token has one way to go and is marked there:
//
//     skill              outcomes      competence    predicted
//     (move t0 p0 p1)    1 of 1        2/3           1
//     (mark t0 p1)       1 of 4        1/3           5/6
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "practice/methods/scored_method.hpp"
#include "tests/practice/methods/method_driver.hpp"

namespace praxis::practice {
namespace {

using test::by_hand;
using test::MethodDriver;

const char* const kMove = "(move t0 p0 p1)";
const char* const kMark = "(mark t0 p1)";

std::map<std::string, CandidateScore> scores(const PracticeOptions& options, std::string& chosen) {
    MethodDriver driver(1, 2, {{0, 1}}, {{1, {0}}}, options);
    driver.tell(kMove, 1, 0);
    driver.tell(kMark, 1, 3);
    const PracticeChoice choice = driver.first_choice();
    chosen = choice.chosen;
    std::map<std::string, CandidateScore> result;
    for (const CandidateScore& candidate : choice.candidates) result[candidate.skill] = candidate;
    EXPECT_EQ(result.size(), choice.candidates.size());
    return result;
}

double bonus(int tries) {
    return 0.1 * std::sqrt(std::log(5) / tries);
}

TEST(Scores, OfPublishedEesAreMinusCostsPlusBonus) {
    std::string chosen;
    auto all = scores(by_hand("ees-published"), chosen);
    ASSERT_EQ(all.size(), 2u);
    const CandidateScore& mark = all[kMark];
    EXPECT_NEAR(mark.competence, 1.0 / 3, 1e-12);
    EXPECT_NEAR(mark.predicted, 5.0 / 6, 1e-12);
    EXPECT_NEAR(mark.cost, -std::log(2.0 / 3) - std::log(5.0 / 6), 1e-9);
    EXPECT_NEAR(mark.score, bonus(4) - mark.cost, 1e-12);
    EXPECT_EQ(mark.tries, 4);
    EXPECT_EQ(mark.successes, 1);
    EXPECT_NEAR(all[kMove].cost, -std::log(1.0 / 3), 1e-9);
    EXPECT_EQ(all[kMove].score, kNever);  // it never failed
    EXPECT_EQ(chosen, kMark);
}

TEST(Scores, OfEesLeaveOutWhatBringsNoGain) {
    std::string chosen;
    PracticeOptions options = by_hand("ees");
    auto all = scores(options, chosen);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_NEAR(all[kMark].score, 0.3 * bonus(4) - all[kMark].cost, 1e-12);
    EXPECT_EQ(chosen, kMark);
    options.competence.bonus = 0;
    EXPECT_EQ(scores(options, chosen)[kMark].score, kNever);
    EXPECT_EQ(chosen, "");
}

TEST(Scores, OfFailFocusAreRatesOfFailurePlusBonus) {
    std::string chosen;
    auto all = scores(by_hand("fail-focus"), chosen);
    EXPECT_NEAR(all[kMark].score, 0.75 + bonus(4), 1e-12);
    EXPECT_NEAR(all[kMove].score, bonus(1), 1e-12);
    EXPECT_EQ(chosen, kMark);
}

TEST(Scores, OfCompetenceGradientAreExpectedGainsPlusBonus) {
    std::string chosen;
    auto all = scores(by_hand("competence-gradient"), chosen);
    EXPECT_NEAR(all[kMark].score, 0.5 + bonus(4), 1e-12);
    EXPECT_NEAR(all[kMove].score, 1.0 / 3 + bonus(1), 1e-12);
    EXPECT_EQ(chosen, kMark);
}

TEST(Scores, OfSkillDiversityFallWithTries) {
    std::string chosen;
    auto all = scores(by_hand("skill-diversity"), chosen);
    EXPECT_DOUBLE_EQ(all[kMark].score, 1.0 / 5);
    EXPECT_DOUBLE_EQ(all[kMove].score, 1.0 / 2);
    EXPECT_EQ(chosen, kMove);
}

TEST(Scores, OnlySkillsTriedAreCandidatesUnlessAllAre) {
    for (const char* candidates : {"tried", "all"}) {
        PracticeOptions options = by_hand("fail-focus");
        options.candidates = candidates;
        MethodDriver driver(2, 3, {{0, 1}, {1, 2}}, {{1, {0}}}, options);
        driver.tell("(mark t0 p2)", 1, 1);
        const PracticeChoice choice = driver.first_choice();
        EXPECT_EQ(choice.candidates.size(), options.candidates == "all" ? 6u : 1u);
    }
}

TEST(Scores, WhatCannotBeReachedIsPassedOver) {
    MethodDriver driver(1, 4, {{0, 1}, {2, 3}, {3, 2}, {1, 0}, {0, 3}}, {{1, {0}}}, by_hand("fail-focus"));
    driver.tell("(move t0 p1 p0)", 0, 9);
    driver.tell("(mark t0 p3)", 1, 1);
    driver.state[0] = 2;  // p1 is out of reach from here
    const PracticeChoice choice = driver.first_choice();
    EXPECT_EQ(choice.candidates.front().skill, "(move t0 p1 p0)");
    EXPECT_EQ(choice.chosen, "(mark t0 p3)");
}

}  // namespace
}  // namespace praxis::practice
