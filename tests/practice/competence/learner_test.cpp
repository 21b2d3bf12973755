// How well the models predict simulated learners.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

struct Errors {
    double competence = 0, prediction = 0;  ///< root mean squared
};

/// 250 learners over 12 cycles of 1..`largest` outcomes; errors against the truth from the third cycle on.
template <class Draw>
Errors measure(const std::string& model, Beta prior, std::size_t largest, Draw draw) {
    constexpr int kLearners = 250, kCycles = 12, kFirst = 2;
    Random random(2024);
    Errors sum;
    for (int i = 0; i < kLearners; ++i) {
        const Learner learner = draw(random);
        CompetenceOptions options;
        options.model = model;
        options.prior = prior;
        const auto estimate = make_competence_model(options);
        int learned_from = 0;
        for (int c = 0; c < kCycles; ++c) {
            const int count = static_cast<int>(1 + random.below(largest));
            const double now = learner.competence(learned_from);
            if (c >= kFirst) {
                const double then = learner.competence(learned_from + count);
                sum.competence += std::pow(estimate->competence() - now, 2);
                sum.prediction += std::pow(estimate->predict(count, 1) - then, 2);
            }
            for (int k = 0; k < count; ++k) estimate->observe(uniform(random) < now);
            estimate->advance_cycle();
            learned_from += count;
        }
    }
    constexpr double kAnswers = kLearners * (kCycles - kFirst);
    return {std::sqrt(sum.competence / kAnswers), std::sqrt(sum.prediction / kAnswers)};
}

Learner improving(Random& random) {
    const double first = uniform(random, 0, 0.6), last = uniform(random, first, 1);
    return {first, last, std::exp(uniform(random, std::log(5), std::log(200)))};
}

Learner idle(Random& random) {
    const double competence = uniform(random, 0, 1);
    return {competence, competence, 1};
}

class Learners : public testing::TestWithParam<Beta> {};

TEST_P(Learners, LatentPredictsBestWhereThereIsGrowth) {
    for (const std::size_t largest : {20u, 60u}) {
        const Errors beta = measure("beta", GetParam(), largest, improving);
        const Errors optimistic = measure("optimistic", GetParam(), largest, improving);
        const Errors latent = measure("latent", GetParam(), largest, improving);
        for (const auto& [name, errors] :
             {std::pair{"beta", beta}, {"optimistic", optimistic}, {"latent", latent}})
            std::printf("prior Beta(%g, %g), cycles of 1..%zu, %-10s: now %.3f, predicted %.3f\n",
                        GetParam().successes, GetParam().failures, largest, name, errors.competence,
                        errors.prediction);
        EXPECT_LT(latent.prediction, 0.12);
        EXPECT_LT(latent.prediction, 0.5 * optimistic.prediction);
        EXPECT_LT(latent.prediction, 0.5 * beta.prediction);
        EXPECT_LT(latent.competence, 0.95 * optimistic.competence);
        EXPECT_LT(latent.competence, 0.95 * beta.competence);
    }
}

TEST_P(Learners, LatentIsNotFooledWhereThereIsNone) {
    const Errors optimistic = measure("optimistic", GetParam(), 20, idle);
    const Errors latent = measure("latent", GetParam(), 20, idle);
    std::printf("prior Beta(%g, %g), no growth: optimistic %.3f, latent %.3f\n", GetParam().successes,
                GetParam().failures, optimistic.prediction, latent.prediction);
    EXPECT_LT(latent.prediction, 0.6 * optimistic.prediction);
    EXPECT_LT(latent.prediction, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Priors, Learners, testing::Values(Beta{10, 1}, Beta{1, 1}));

}  // namespace
}  // namespace praxis::practice
