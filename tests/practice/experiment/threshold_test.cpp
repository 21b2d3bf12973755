#include "practice/experiment/threshold.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

using Curve = std::vector<CurvePoint>;

const Curve kCurve = {{0, 0, 0.1}, {1, 250, 0.8}, {2, 500, 0.7}, {3, 740, 0.9}, {4, 1000, 0.95}};

TEST(Threshold, TheFirstEvaluationThatReachesIt) {
    EXPECT_EQ(transitions_to(kCurve, {0.8}), (Reached{250, false}));
    EXPECT_EQ(transitions_to(kCurve, {0.75}), (Reached{250, false}));  // not interpolated
    EXPECT_EQ(transitions_to(kCurve, {0.1}), (Reached{0, false}));
    EXPECT_EQ(transitions_to(kCurve, {0.95}), (Reached{1000, false}));
}

TEST(Threshold, MayHaveToStay) {
    EXPECT_EQ(transitions_to(kCurve, {0.8, true}), (Reached{740, false}));
    EXPECT_EQ(transitions_to(kCurve, {0.05, true}), (Reached{0, false}));
    Curve falls = kCurve;
    falls.push_back({5, 1200, 0.2});
    EXPECT_EQ(transitions_to(falls, {0.8, true}), (Reached{1200, true}));
}

TEST(Threshold, RunsThatNeverReachItAreCensored) {
    EXPECT_EQ(transitions_to(kCurve, {0.96}), (Reached{1000, true}));
}

TEST(Threshold, RefusesOddThresholds) {
    EXPECT_THROW(transitions_to({}, {0.8}), std::invalid_argument);
    for (const double odd : {-0.1, 1.1, std::nan("")})
        EXPECT_THROW(transitions_to(kCurve, {odd}), std::invalid_argument);
}

TEST(Threshold, CensoredRunsStayInTheSummary) {
    const std::vector<Reached> runs = {{100, false}, {1000, true}, {300, false}};
    const ReachedSummary summary = summarise_reached(runs);
    EXPECT_EQ(summary.censored, 1u);
    EXPECT_NEAR(summary.mean.value, 1400.0 / 3, 1e-9);
    EXPECT_EQ(summary.mean.count, 3u);
    EXPECT_EQ(summary.median, 300);
}

TEST(Threshold, TheMedianIsUnknownIfHalfAreCensored) {
    EXPECT_TRUE(std::isinf(summarise_reached(std::vector<Reached>{{100, false}, {50, true}}).median));
    EXPECT_EQ(summarise_reached(std::vector<Reached>{{100, false}, {200, false}}).median, 150);
    // A short run that was censored early does not pull the median down.
    EXPECT_EQ(summarise_reached(std::vector<Reached>{{100, false}, {10, true}, {200, false}}).median, 200);
}

TEST(PracticeRatio, ByHand) {
    const std::vector<Reached> a = {{300, false}, {500, false}},
                               b = {{100, false}, {200, false}, {100, false}};
    EXPECT_DOUBLE_EQ(practice_ratio(a, b).value, 3);
    const PracticeRatio ratio = practice_ratio(a, b);
    EXPECT_GE(ratio.low, 1.5);  // 300 / 200
    EXPECT_LE(ratio.high, 5);   // 500 / 100
    EXPECT_LT(ratio.low, 3);
    EXPECT_GT(ratio.high, 3);
}

TEST(PracticeRatio, TheSameSeedGivesTheSameInterval) {
    const std::vector<Reached> a = {{300, false}, {510, false}, {700, false}},
                               b = {{100, false}, {230, false}};
    EXPECT_EQ(practice_ratio(a, b).low, practice_ratio(a, b).low);
    EXPECT_EQ(practice_ratio(a, b).high, practice_ratio(a, b).high);
}

TEST(PracticeRatio, SaysWhatCensoredRunsMakeOfIt) {
    const std::vector<Reached> whole = {{100, false}, {200, false}}, cut = {{100, false}, {500, true}};
    EXPECT_EQ(bound_of(practice_ratio(whole, whole)), "");
    EXPECT_EQ(bound_of(practice_ratio(cut, whole)), "at least");
    EXPECT_EQ(bound_of(practice_ratio(whole, cut)), "at most");
    EXPECT_EQ(bound_of(practice_ratio(cut, cut)), "unclear");
}

TEST(PracticeRatio, NothingToPractise) {
    const std::vector<Reached> zero = {{0, false}}, some = {{10, false}};
    EXPECT_EQ(practice_ratio(zero, zero).value, 1);
    EXPECT_EQ(practice_ratio(zero, some).value, 0);
    EXPECT_TRUE(std::isinf(practice_ratio(some, zero).high));
    EXPECT_THROW(practice_ratio({}, some), std::invalid_argument);
    EXPECT_THROW(practice_ratio(some, some, {0.95, 0, 1}), std::invalid_argument);
    EXPECT_THROW(practice_ratio(some, some, {1.0, 10, 1}), std::invalid_argument);
}

TEST(PracticeRatio, TheIntervalCoversTheTrueRatio) {
    Random random(5);
    const auto runs = [&](double mean) {
        std::vector<Reached> result(30);
        for (Reached& run : result)
            run.transitions = static_cast<std::int64_t>(-mean * std::log(1 - uniform(random)));
        return result;
    };
    int covered = 0;
    constexpr int kTrials = 400;
    for (int trial = 0; trial < kTrials; ++trial) {
        const PracticeRatio ratio = practice_ratio(runs(30'000), runs(10'000), {0.95, 400, 9});
        covered += ratio.low <= 3 && 3 <= ratio.high;
    }
    EXPECT_GT(covered, 0.89 * kTrials);
    EXPECT_LT(covered, 0.99 * kTrials);
}

}  // namespace
}  // namespace praxis::practice
