#include "belief/measures.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis::belief {
namespace {

TEST(Measures, WilsonsIntervalHasKnownValues) {
    const Estimate most = rate(8, 10);
    EXPECT_DOUBLE_EQ(most.value, 0.8);
    EXPECT_NEAR(most.low, 0.4902, 5e-5);
    EXPECT_NEAR(most.high, 0.9433, 5e-5);
    const Estimate none = rate(0, 10);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 0.2775, 5e-5);
    EXPECT_EQ(rate(200, 200).high, 1);
    EXPECT_NEAR(rate(200, 200).low, 0.9812, 5e-5);
    EXPECT_EQ(rate(0, 0).low, 0);
    EXPECT_EQ(rate(0, 0).high, 1);
    EXPECT_THROW(rate(2, 1), std::invalid_argument);
}

RC_GTEST_PROP(MeasuresProperty, WilsonsIntervalSolvesItsEquation, ()) {
    const auto count = *rc::gen::inRange<std::size_t>(1, 2000);
    const auto successes = *rc::gen::inRange<std::size_t>(0, count + 1);
    const Estimate estimate = rate(successes, count);
    RC_ASSERT(0 <= estimate.low && estimate.low <= estimate.value && estimate.value <= estimate.high);
    RC_ASSERT(estimate.high <= 1);
    // |p - q| = z sqrt(q (1 - q) / n) at both ends q
    for (const double q : {estimate.low, estimate.high}) {
        const double deviation = 1.959964 * std::sqrt(q * (1 - q) / static_cast<double>(count));
        if (q > 0 && q < 1) RC_ASSERT(std::abs(std::abs(estimate.value - q) - deviation) < 1e-6);
    }
}

TEST(Measures, WilsonsIntervalCoversTheTruth) {
    Random random(1);
    std::size_t covered = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::size_t successes = 0;
        for (int i = 0; i < 50; ++i) successes += random.below(10) < 9;
        const Estimate estimate = rate(successes, 50);
        covered += estimate.low <= 0.9 && 0.9 <= estimate.high;
    }
    EXPECT_GT(covered, 1860U);
    EXPECT_LT(covered, 1990U);
}

/// Half of the interval in standard errors: the quantile that was used.
double quantile(std::size_t count) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i % 2));
    const Estimate estimate = mean(values);
    double squares = 0;
    for (const double value : values) squares += (value - estimate.value) * (value - estimate.value);
    const auto n = static_cast<double>(count);
    return (estimate.high - estimate.value) / std::sqrt(squares / (n - 1) / n);
}

TEST(Measures, StudentsQuantilesHaveKnownValues) {
    EXPECT_NEAR(quantile(2), 12.7062, 1e-4);
    EXPECT_NEAR(quantile(11), 2.2281, 1e-4);
    EXPECT_NEAR(quantile(31), 2.0423, 1e-4);
    EXPECT_NEAR(quantile(32), 2.0395, 1e-4);
    EXPECT_NEAR(quantile(61), 2.0003, 1e-4);
    EXPECT_NEAR(quantile(201), 1.9719, 1e-4);
}

TEST(Measures, MeansOfFewValues) {
    EXPECT_EQ(mean({}).value, 0);
    const Estimate one = mean(std::vector<double>{3});
    EXPECT_EQ(one.low, 3);
    EXPECT_EQ(one.high, 3);
    const Estimate same = mean(std::vector<double>{2, 2, 2});
    EXPECT_EQ(same.low, 2);
    EXPECT_EQ(same.high, 2);
}

TEST(Measures, SuccessIsWeightedByLength) {
    EXPECT_DOUBLE_EQ(success_weighted(true, 10, 5), 0.5);
    EXPECT_DOUBLE_EQ(success_weighted(true, 5, 5), 1);
    EXPECT_DOUBLE_EQ(success_weighted(true, 4, 5), 1);  // lucky: shorter than the best policy's
    EXPECT_DOUBLE_EQ(success_weighted(false, 5, 5), 0);
    EXPECT_DOUBLE_EQ(success_weighted(true, 0, 0), 1);
    EXPECT_DOUBLE_EQ(success_weighted(true, 3, 0), 0);
    EXPECT_THROW(success_weighted(true, -1, 1), std::invalid_argument);
    EXPECT_THROW(success_weighted(true, 1, std::nan("")), std::invalid_argument);
    EXPECT_THROW(success_weighted(true, INFINITY, 1), std::invalid_argument);
}

TEST(Measures, OfRuns) {
    std::vector<MeasuredRun> runs(4);
    runs[0] = {true, false, 10, 10, 5, 2, 0.5};
    runs[1] = {true, false, 20, 10, 5, 4, 0.5};
    runs[2] = {false, true, 6, 10, 5, 1, 0.5};
    runs[3] = {false, false, 40, 10, 5, 9, 0.5};
    const Measures measures = measure(runs);
    EXPECT_EQ(measures.runs, 4U);
    EXPECT_DOUBLE_EQ(measures.success.value, 0.5);
    EXPECT_DOUBLE_EQ(measures.false_success.value, 0.25);
    EXPECT_DOUBLE_EQ(measures.spl_info->value, (1 + 0.5) / 4);
    EXPECT_DOUBLE_EQ(measures.spl_omni->value, (0.5 + 0.25) / 4);
    EXPECT_DOUBLE_EQ(*measures.length_ratio, 30.0 / 20);
    EXPECT_GE(measures.spl_info->low, 0);
    EXPECT_LE(measures.spl_info->high, 1);
    EXPECT_DOUBLE_EQ(measures.length.value, 19);
    EXPECT_DOUBLE_EQ(measures.successful_length.value, 15);
    EXPECT_DOUBLE_EQ(measures.plans.value, 4);
    EXPECT_DOUBLE_EQ(measures.processor_seconds.value, 0.5);

    EXPECT_NE(to_string(measures).find("steps / best         1.500"), std::string::npos)
        << to_string(measures);

    runs[3].policy_length.reset();
    EXPECT_FALSE(measure(runs).spl_info);
    EXPECT_TRUE(measure(runs).spl_omni);
    EXPECT_FALSE(measure(runs).length_ratio);
    EXPECT_FALSE(measure({}).spl_omni);
    EXPECT_FALSE(measure({}).length_ratio);
    const std::string text = to_string(measure(runs));
    EXPECT_NE(text.find("SPL (informed)           -"), std::string::npos) << text;
    EXPECT_NE(text.find("50.0"), std::string::npos) << text;
}

}  // namespace
}  // namespace praxis::belief
