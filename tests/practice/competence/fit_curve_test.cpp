#include "practice/competence/fit_curve.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

std::vector<Cycle> random_cycles(Random& random, std::size_t most, int largest) {
    std::vector<Cycle> cycles(1 + random.below(most));
    double before = 0;
    for (Cycle& cycle : cycles) {
        cycle.before = before;
        const double success = uniform(random);
        for (std::size_t n = 1 + random.below(static_cast<std::size_t>(largest)); n > 0; --n)
            cycle.outcomes.add(uniform(random) < success);
        before += static_cast<double>(cycle.outcomes.total());
    }
    return cycles;
}

/// J with the best competences, by the definition.
double objective(const std::vector<Cycle>& cycles, const CurvePrior& prior,
                 const CurveParameters& parameters) {
    double sum = 0;
    for (const Cycle& cycle : cycles) {
        const double mean = LearningCurve(parameters).mean(cycle.before);
        const double c = most_probable_competence(mean, cycle.outcomes);
        sum += static_cast<double>(cycle.outcomes.successes) * std::log(c) +
               static_cast<double>(cycle.outcomes.failures) * std::log(1 - c) -
               (c - mean) * (c - mean) / (2 * kCompetenceVariance);
    }
    for (std::size_t k = 0; k < 3; ++k)
        sum -= std::pow((parameters[k] - prior.mean[k]) / prior.deviation[k], 2) / 2;
    return sum;
}

TEST(MostProbableCompetence, SolvesItsEquation) {
    EXPECT_DOUBLE_EQ(most_probable_competence(0.3, {}), 0.3);
    // One success: 1 / c = 100 (c - mean), so c = (mean + sqrt(mean^2 + 0.04)) / 2.
    EXPECT_NEAR(most_probable_competence(0.5, {1, 0}), (0.5 + std::sqrt(0.29)) / 2, 1e-12);
    // One failure, the mirror image.
    EXPECT_NEAR(most_probable_competence(0.5, {0, 1}), 1 - (0.5 + std::sqrt(0.29)) / 2, 1e-12);
    EXPECT_NEAR(most_probable_competence(0.5, {7, 7}), 0.5, 1e-12);
}

TEST(MostProbableCompetence, IsThePosteriorMeanOfTheMatchingBetaInTheMiddle) {
    // Mean 0.5 and variance 0.01 are Beta(12, 12).
    EXPECT_NEAR(most_probable_competence(0.5, {3, 1}), 15.0 / 28, 0.005);
    EXPECT_NEAR(most_probable_competence(0.5, {20, 10}), 32.0 / 54, 0.005);
}

TEST(MostProbableCompetence, IsClippedAtTheEnds) {
    EXPECT_DOUBLE_EQ(most_probable_competence(0.98, {50, 0}), 0.999);
    EXPECT_DOUBLE_EQ(most_probable_competence(0.02, {0, 50}), 0.001);
    EXPECT_GT(most_probable_competence(0.001, {1000000000, 0}), 0.99);
}

RC_GTEST_PROP(MostProbableCompetence, IsAMaximum, ()) {
    const double mean = *rc::gen::inRange(1, 1000) / 1000.0;
    const Counts outcomes{*rc::gen::inRange(0, 60), *rc::gen::inRange(0, 60)};
    const auto density = [&](double c) {
        return static_cast<double>(outcomes.successes) * std::log(c) +
               static_cast<double>(outcomes.failures) * std::log(1 - c) -
               (c - mean) * (c - mean) / (2 * kCompetenceVariance);
    };
    const double best = density(most_probable_competence(mean, outcomes));
    for (double c = 0.001; c <= 0.999; c += 0.001) RC_ASSERT(density(c) <= best + 1e-9);
}

RC_GTEST_PROP(FitCurve, TheObjectiveNeverFalls, ()) {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Cycle> cycles = random_cycles(random, 25, 40);
    const CurveParameters guess{uniform(random, -5, 5), uniform(random, -5, 5), uniform(random, -6, 2)};
    const CurveFit fit = fit_curve(cycles, {}, guess);
    RC_ASSERT(!fit.objective.empty());
    for (std::size_t i = 1; i < fit.objective.size(); ++i)
        RC_ASSERT(fit.objective[i] >= fit.objective[i - 1] - 1e-9);
}

RC_GTEST_PROP(FitCurve, TheObjectiveIsWhatItSays, ()) {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<Cycle> cycles = random_cycles(random, 10, 20);
    const CurveFit fit = fit_curve(cycles, {}, CurvePrior{}.mean);
    // The E-step that follows the last round can only raise it, and by little once rounds gain little.
    const double reached = objective(cycles, {}, fit.parameters);
    RC_ASSERT(reached >= fit.objective.back() - 1e-9);
    RC_ASSERT(reached <= fit.objective.back() + 0.5);
}

TEST(FitCurve, HardlyEverIsACurveOfAGridMuchBetter) {
    constexpr int kHistories = 200;
    const CurvePrior prior;
    Random random(77);
    int missed = 0;
    for (int i = 0; i < kHistories; ++i) {
        const std::vector<Cycle> cycles = random_cycles(random, 6, 12);
        const double reached = objective(cycles, prior, fit_curve(cycles, prior, prior.mean).parameters);
        double best = reached;
        for (int start = -4; start <= 4; ++start)
            for (int growth = -3; growth <= 5; ++growth)
                for (int rate = -6; rate <= 0; ++rate)
                    best = std::max(best, objective(cycles, prior,
                                                    {static_cast<double>(start), static_cast<double>(growth),
                                                     static_cast<double>(rate)}));
        missed += best > reached + 0.1;
    }
    EXPECT_LE(missed, kHistories / 100);
}

TEST(FitCurve, WithoutCyclesIsThePrior) {
    const CurvePrior prior;
    EXPECT_EQ(fit_curve({}, prior, prior.mean).parameters, prior.mean);
}

}  // namespace
}  // namespace praxis::practice
