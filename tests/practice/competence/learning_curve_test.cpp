#include "practice/competence/learning_curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace praxis::practice {
namespace {

CurveParameters random_parameters() {
    const auto number = [] { return *rc::gen::inRange(-400, 400) / 100.0; };
    return {number(), number(), number()};
}

TEST(LearningCurve, HasTheValuesOfItsFormula) {
    const LearningCurve curve({0, 0, 0});  // from 1/2 to sigmoid(1) at rate 1
    EXPECT_DOUBLE_EQ(curve.mean(0), 0.5);
    EXPECT_NEAR(curve.mean(1), 0.5 + (0.7310585786 - 0.5) * (1 - std::exp(-1)), 1e-9);
    EXPECT_NEAR(curve.mean(1e9), 0.7310585786, 1e-9);
    const LearningCurve steep({std::log(0.25), 2, -1});  // growth 3, rate 1/e
    EXPECT_DOUBLE_EQ(steep.mean(0), 0.2);
    EXPECT_NEAR(steep.mean(1e9), 1 / (1 + 4 * std::exp(-3)), 1e-12);
}

RC_GTEST_PROP(LearningCurve, Rises, ()) {
    const LearningCurve curve(random_parameters());
    double previous = 0;
    for (double x = 0; x < 1e6; x = 2 * x + 1) {
        const double mean = curve.mean(x);
        RC_ASSERT(mean >= previous && mean < 1);
        previous = mean;
    }
}

RC_GTEST_PROP(LearningCurve, KnowsItsGradient, ()) {
    const CurveParameters parameters = random_parameters();
    const double x = *rc::gen::inRange(0, 50);
    CurveParameters gradient;
    RC_ASSERT(LearningCurve(parameters).mean(x, gradient) == LearningCurve(parameters).mean(x));
    for (std::size_t k = 0; k < 3; ++k) {
        constexpr double kStep = 1e-5;
        CurveParameters up = parameters, down = parameters;
        up[k] += kStep;
        down[k] -= kStep;
        const double slope = (LearningCurve(up).mean(x) - LearningCurve(down).mean(x)) / (2 * kStep);
        RC_ASSERT(std::abs(gradient[k] - slope) < 1e-4);
    }
}

}  // namespace
}  // namespace praxis::practice
