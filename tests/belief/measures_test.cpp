#include "belief/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace praxis::belief {
namespace {

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
    EXPECT_DOUBLE_EQ(measures.successful_length->value, 15);
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
    EXPECT_EQ(measure({}).success, IntervalEstimate{});
    const std::string text = to_string(measure(runs));
    EXPECT_NE(text.find("SPL (informed)           -"), std::string::npos) << text;
    EXPECT_NE(text.find("50.0"), std::string::npos) << text;
}

TEST(Measures, OneFailedRunHasNoSpread) {
    const std::vector<MeasuredRun> runs = {{false, false, 7, 10, 5, 2, 0.5}};
    const Measures measures = measure(runs);
    EXPECT_FALSE(measures.successful_length);
    EXPECT_EQ(measures.success.low, 0);
    EXPECT_EQ(measures.spl_info->high, 1);
    const std::string text = to_string(measures);
    EXPECT_NE(text.find("\nsteps                 7.00\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nof successes             -\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace praxis::belief
