#include "search/statistics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis {
namespace {

/// In [0, 1).
double uniform(Random& random) {
    return static_cast<double>(random.next() >> 11) * 0x1.0p-53;
}

double normal(Random& random) {
    const double radius = std::sqrt(-2 * std::log(1 - uniform(random)));
    return radius * std::cos(2 * std::numbers::pi * uniform(random));
}

bool covers(const IntervalEstimate& estimate, double truth) {
    return estimate.low <= truth && truth <= estimate.high;
}

TEST(Statistics, QuantilesAreThoseOfTheTables) {
    EXPECT_NEAR(student_quantile(0.975, 1), 12.7062, 1e-4);
    EXPECT_NEAR(student_quantile(0.975, 9), 2.26216, 1e-5);
    EXPECT_NEAR(student_quantile(0.975, 29), 2.04523, 1e-5);
    EXPECT_NEAR(student_quantile(0.95, 4), 2.13185, 1e-5);
    EXPECT_NEAR(student_quantile(0.025, 29), -2.04523, 1e-5);
    EXPECT_NEAR(student_quantile(0.975, 1e7), 1.95996, 1e-5);
    EXPECT_NEAR(student_quantile(0.5, 3), 0, 1e-12);
    for (const double odd : {0.0, 1.0, -1.0, std::nan("")})
        EXPECT_THROW(student_quantile(odd, 3), std::invalid_argument);
    EXPECT_THROW(student_quantile(0.5, 0), std::invalid_argument);
}

TEST(Statistics, MeanByHand) {
    const std::vector<double> values = {1, 2, 3, 4, 5};  // deviation sqrt(2.5), error sqrt(0.5), t = 2.77645
    const IntervalEstimate estimate = mean_estimate(values);
    EXPECT_DOUBLE_EQ(estimate.value, 3);
    EXPECT_NEAR(estimate.high - 3, 2.776445 * std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(3 - estimate.low, 2.776445 * std::sqrt(0.5), 1e-6);
    EXPECT_EQ(estimate.count, 5u);
    EXPECT_LT(mean_estimate(values, 0.9).high, estimate.high);
}

TEST(Statistics, EqualValuesHaveNoSpread) {
    const IntervalEstimate estimate = mean_estimate(std::vector<double>(30, 0.1));
    EXPECT_EQ(estimate, (IntervalEstimate{0.1, 0.1, 0.1, 30}));
}

TEST(Statistics, OneValueSaysNothingAboutTheSpread) {
    const IntervalEstimate estimate = mean_estimate(std::vector<double>{0.7});
    EXPECT_EQ(estimate.value, 0.7);
    EXPECT_EQ(estimate.low, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(estimate.high, std::numeric_limits<double>::infinity());
}

TEST(Statistics, RefusesWhatCannotBeEstimated) {
    EXPECT_THROW(mean_estimate({}), std::invalid_argument);
    EXPECT_THROW(mean_estimate(std::vector<double>{1, std::nan("")}), std::invalid_argument);
    EXPECT_THROW(mean_estimate(std::vector<double>{1, 2}, 1), std::invalid_argument);
    EXPECT_THROW(proportion_estimate(1, 0), std::invalid_argument);
    EXPECT_THROW(proportion_estimate(3, 2), std::invalid_argument);
    EXPECT_THROW(proportion_estimate(-1, 2), std::invalid_argument);
    EXPECT_THROW(compare_paired(std::vector<double>{1}, std::vector<double>{1, 2}), std::invalid_argument);
}

TEST(Statistics, MeansAreCoveredAsOftenAsTheConfidenceSays) {
    Random random(7);
    for (const double confidence : {0.8, 0.95}) {
        int covered = 0;
        constexpr int kTrials = 4000;
        for (int trial = 0; trial < kTrials; ++trial) {
            std::vector<double> values(6);
            for (double& value : values) value = 3 + 2 * normal(random);
            covered += covers(mean_estimate(values, confidence), 3);
        }
        // Four standard deviations of a binomial.
        EXPECT_NEAR(covered, confidence * kTrials, 4 * std::sqrt(kTrials * confidence * (1 - confidence)));
    }
}

TEST(Statistics, WilsonByHand) {
    // n = 10, p = 0.8, z = 1.959964: middle 0.716740, reach 0.226578.
    const IntervalEstimate some = proportion_estimate(8, 10);
    EXPECT_NEAR(some.low, 0.490162, 1e-6);
    EXPECT_NEAR(some.high, 0.943318, 1e-6);
    const IntervalEstimate all = proportion_estimate(100, 100);
    EXPECT_EQ(all.high, 1);
    EXPECT_NEAR(all.low, 0.963007, 1e-6);  // n / (n + z^2)
    const IntervalEstimate none = proportion_estimate(0, 100);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 1 - all.low, 1e-12);
}

RC_GTEST_PROP(StatisticsProperty, WilsonsIntervalSolvesItsEquation, ()) {
    const auto trials = *rc::gen::inRange<std::int64_t>(1, 2000);
    const auto successes = *rc::gen::inRange<std::int64_t>(0, trials + 1);
    const IntervalEstimate estimate = proportion_estimate(successes, trials);
    RC_ASSERT(0 <= estimate.low && estimate.low <= estimate.value && estimate.value <= estimate.high);
    RC_ASSERT(estimate.high <= 1);
    // |p - q| = z sqrt(q (1 - q) / n) at both ends q
    for (const double q : {estimate.low, estimate.high}) {
        const double deviation = 1.959964 * std::sqrt(q * (1 - q) / static_cast<double>(trials));
        if (q > 0 && q < 1) RC_ASSERT(std::abs(std::abs(estimate.value - q) - deviation) < 1e-6);
    }
}

TEST(Statistics, FractionsStayWithinBounds) {
    EXPECT_EQ(fraction_estimate(std::vector<double>{0.9}), (IntervalEstimate{0.9, 0, 1, 1}));
    const IntervalEstimate few = fraction_estimate(std::vector<double>{0.8, 1});
    EXPECT_EQ(few.high, 1);
    EXPECT_EQ(few.low, std::max(0.0, mean_estimate(std::vector<double>{0.8, 1}).low));
}

TEST(Statistics, ProportionsAreCovered) {
    Random random(11);
    for (const double share : {0.05, 0.5, 0.9}) {
        int covered = 0;
        constexpr int kTrials = 3000;
        for (int trial = 0; trial < kTrials; ++trial) {
            int successes = 0;
            for (int i = 0; i < 60; ++i) successes += uniform(random) < share;
            covered += covers(proportion_estimate(successes, 60), share);
        }
        EXPECT_GT(covered, 0.92 * kTrials) << share;
        EXPECT_LT(covered, 0.99 * kTrials) << share;
    }
}

TEST(Statistics, PairsByHand) {
    const std::vector<double> a = {5, 7, 3, 4}, b = {4, 4, 3, 5};  // differences 1 3 0 -1
    const PairedComparison comparison = compare_paired(a, b);
    EXPECT_DOUBLE_EQ(comparison.difference.value, 0.75);
    EXPECT_EQ(comparison.wins, 2u);
    EXPECT_EQ(comparison.losses, 1u);
    EXPECT_EQ(comparison.ties, 1u);
    // Squares 0.0625 + 5.0625 + 0.5625 + 3.0625 = 8.75; error sqrt(8.75 / 12); t = 0.878310 with 3 degrees,
    // for which the distribution has a closed form: p = 1 - 2 / pi (atan x + x / (1 + x^2)), x = t / sqrt 3.
    EXPECT_NEAR(comparison.difference.high - 0.75, 3.182446 * std::sqrt(8.75 / 12), 1e-5);
    EXPECT_NEAR(comparison.probability, 0.4444381, 1e-7);
}

TEST(Statistics, PairingRemovesWhatSeedsHaveInCommon) {
    Random random(3);
    std::vector<double> a, b;
    for (int seed = 0; seed < 20; ++seed) {
        const double difficulty = 10 * normal(random);
        a.push_back(difficulty + 1 + 0.3 * normal(random));
        b.push_back(difficulty);
    }
    EXPECT_LT(compare_paired(a, b).probability, 1e-6);
    EXPECT_GT(mean_estimate(a).high, mean_estimate(b).low);
}

TEST(Statistics, PairsThatNeverDiffer) {
    const std::vector<double> a = {1, 1, 1}, b = {0, 0, 0};
    EXPECT_EQ(compare_paired(a, a).probability, 1);
    EXPECT_EQ(compare_paired(a, b).probability, 0);
    EXPECT_EQ(compare_paired(a, b).difference, (IntervalEstimate{1, 1, 1, 3}));
}

}  // namespace
}  // namespace praxis
