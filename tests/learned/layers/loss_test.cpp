#include "learned/layers/loss.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "learned/maps/navigation.hpp"
#include "tests/learned/support/fields.hpp"

namespace praxis::learned {
namespace {

class PolicyLoss : public testing::TestWithParam<Loss> {
  protected:
    PolicyLoss() {
        Random random(1);
        problem = navigation_problem(9, random);
        randomise(policy, random);
    }
    MapProblem problem;
    Planes<double> policy{4, 9, 9, 0}, gradient = policy, unused = policy;
};
INSTANTIATE_TEST_SUITE_P(Both, PolicyLoss, testing::Values(Loss::all_optimal, Loss::one_label));

TEST_P(PolicyLoss, HasTheGradientOfItsDifferenceQuotients) {
    policy_loss(GetParam(), problem, policy, 2.0, gradient);
    for (int m = 0; m < 4; ++m)
        for (int row = 0; row < 9; ++row)
            for (int column = 0; column < 9; ++column) {
                constexpr double kStep = 1e-5;
                double& logit = policy.at(m, row, column);
                const double value = logit;
                logit = value + kStep;
                const double above = policy_loss(GetParam(), problem, policy, 1.0, unused);
                logit = value - kStep;
                const double below = policy_loss(GetParam(), problem, policy, 1.0, unused);
                logit = value;
                EXPECT_NEAR(gradient.at(m, row, column), 2 * (above - below) / (2 * kStep), 1e-9);
            }
}

TEST_P(PolicyLoss, CountsTheCellsItShould) {
    policy_loss(GetParam(), problem, policy, 1.0, gradient);
    for (int cell = 0; cell < problem.cells(); ++cell) {
        double size = 0;
        for (int m = 0; m < 4; ++m) size += std::abs(gradient.at(m, cell / 9, cell % 9));
        const bool counts = GetParam() == Loss::one_label || problem.optimal[static_cast<std::size_t>(cell)];
        EXPECT_EQ(size > 0, counts && problem.optimal[static_cast<std::size_t>(cell)] != 15);
    }
}

TEST_P(PolicyLoss, IsLogFourForAnIndifferentPolicyWithOneLabelAndFiniteForAHopelessOne) {
    policy.clear();
    const double loss = policy_loss(GetParam(), problem, policy, 1.0, gradient);
    if (GetParam() == Loss::one_label) {
        EXPECT_NEAR(loss, std::log(4.0), 1e-12);
    } else {
        EXPECT_LT(loss, std::log(4.0));
    }
    Planes<float> hopeless(4, 9, 9, 0), of_hopeless = hopeless;
    for (int cell = 0; cell < problem.cells(); ++cell)
        for (int m = 0; m < 4; ++m)
            hopeless.at(m, cell / 9, cell % 9) =
                problem.optimal[static_cast<std::size_t>(cell)] >> m & 1 ? -1e4f : 1e4f;
    EXPECT_TRUE(std::isfinite(policy_loss(GetParam(), problem, hopeless, 1.0f, of_hopeless)));
    for (std::size_t i = 0; i < of_hopeless.size(); ++i) ASSERT_TRUE(std::isfinite(of_hopeless.data()[i]));
}

}  // namespace
}  // namespace praxis::learned
