#include "practice/competence/latent_model.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

TEST(LatentModel, IsTheBetaModelInItsFirstCycle) {
    LatentModel model({1, 1}, 0.2);
    observe(model, 1, 3);
    EXPECT_EQ(model.posterior(), (Beta{2, 4}));
    EXPECT_DOUBLE_EQ(model.predict(10, 1), 2.0 / 6 + 0.2);
    EXPECT_TRUE(model.objective().empty());
}

TEST(LatentModel, StartsACycleOnItsCurve) {
    LatentModel model({1, 1}, 0.5);
    cycle(model, 2, 6);
    EXPECT_DOUBLE_EQ(model.competence(), model.curve(8));
    EXPECT_NEAR(model.posterior().variance(), kCompetenceVariance, 1e-12);
    EXPECT_DOUBLE_EQ(model.predict(5, 0), model.curve(13));
    EXPECT_DOUBLE_EQ(model.predict(0, 3), model.curve(8));
}

TEST(LatentModel, OutcomesOfTheCycleMoveCompetenceAndCountAsPractice) {
    LatentModel model({1, 1}, 0.5);
    cycle(model, 2, 6);
    observe(model, 1, 0);
    const double mean = model.curve(8);
    // One success: 1 / c = 100 (c - mean).
    const double expected = (mean + std::sqrt(mean * mean + 0.04)) / 2;
    EXPECT_NEAR(model.competence(), expected, 1e-9);
    EXPECT_NEAR(model.predict(5, 1), expected + model.curve(14) - mean, 1e-9);
}

TEST(LatentModel, ImpossibleAndPerfectSkillsAreRecognised) {
    LatentModel impossible({1, 1}, 0.5), perfect({1, 1}, 0.5);
    for (int i = 0; i < 10; ++i) {
        cycle(impossible, 0, 10);
        cycle(perfect, 10, 0);
    }
    EXPECT_LT(impossible.competence(), 0.05);
    EXPECT_LT(impossible.predict(10, 1), 0.1);
    EXPECT_GT(perfect.competence(), 0.97);
}

TEST(LatentModel, ASkillThatIsLearnedIsPredictedToBeBetterAndOneThatIsNotIsNot) {
    LatentModel improving({1, 1}, 0.5), idle({1, 1}, 0.5);
    for (int successes = 1; successes <= 8; ++successes) {
        cycle(improving, successes, 10 - successes);
        cycle(idle, 3, 7);
    }
    EXPECT_NEAR(improving.competence(), 0.75, 0.1);
    EXPECT_NEAR(idle.competence(), 0.3, 0.05);
    const double growth = improving.predict(20, 1) - improving.competence();
    const double no_growth = idle.predict(20, 1) - idle.competence();
    EXPECT_GT(growth, 3 * no_growth) << growth << " against " << no_growth;
}

TEST(LatentModel, ThePriorSpeaksOfTheStart) {
    LatentModel model({1, 1}, 0.5), hopeful({30, 1}, 0.5);
    for (LatentModel* each : {&model, &hopeful}) {
        cycle(*each, 1, 2);
        cycle(*each, 2, 1);
    }
    EXPECT_GT(hopeful.curve(0), model.curve(0) + 0.02);
    EXPECT_EQ(model.evidence(), (Counts{1, 2}));
    const double before = model.curve(0);
    model.set_prior({30, 1});
    EXPECT_GT(model.curve(0), before);
}

RC_GTEST_PROP(LatentModel, TheObjectiveNeverFalls, ()) {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    LatentModel model({uniform(random, 0.1, 20), uniform(random, 0.1, 20)}, 0.5);
    for (int i = 0; i < 12; ++i) {
        cycle(model, static_cast<int>(random.below(30)), static_cast<int>(random.below(30)));
        for (std::size_t round = 1; round < model.objective().size(); ++round)
            RC_ASSERT(model.objective()[round] >= model.objective()[round - 1] - 1e-9);
    }
}

}  // namespace
}  // namespace praxis::practice
