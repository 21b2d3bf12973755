#include "practice/competence/competences.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "practice/competence/shared_prior.hpp"
#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

CompetenceOptions options_of(const std::string& model, Beta prior = {1, 1}) {
    CompetenceOptions options;
    options.model = model;
    options.prior = prior;
    return options;
}

void observe(Competences& competences, std::size_t skill, int successes, int failures) {
    for (int i = 0; i < successes; ++i) competences.observe(skill, true);
    for (int i = 0; i < failures; ++i) competences.observe(skill, false);
}

TEST(Competences, CountEverythingAndEstimateFromTheGreedyOutcomes) {
    Competences competences(std::vector<std::int32_t>{0, 0}, options_of("beta"), false);
    competences.observe(1, true, false);
    competences.observe(1, false, true);
    competences.observe(1, true, false);
    EXPECT_EQ(competences.outcomes(1), (Counts{2, 1}));
    EXPECT_EQ(competences.tries(1), 3);
    EXPECT_EQ(competences.successes(1), 2);
    EXPECT_EQ(competences.tries(0), 0);
    EXPECT_EQ(competences.tries(), 3);
    EXPECT_EQ(competences.posterior(1), (Beta{1, 2}));
    EXPECT_EQ(competences.posterior(0), (Beta{1, 1}));
}

TEST(Competences, ListTheTriedInTheOrderOfTheirFirstOutcome) {
    Competences competences(std::vector<std::int32_t>(5, 0), options_of("beta"), true);
    for (const std::size_t skill : {3u, 1u, 3u, 4u}) competences.observe(skill, true);
    EXPECT_EQ(std::vector<std::size_t>(competences.tried().begin(), competences.tried().end()),
              (std::vector<std::size_t>{3, 1, 4}));
}

TEST(Competences, RefuseSkillsThatThereAreNotAndNegativeNumbers) {
    Competences competences(std::vector<std::int32_t>{0, 1}, options_of("beta"), true);
    EXPECT_THROW(competences.observe(2, true), std::invalid_argument);
    EXPECT_THROW(competences.competence(2), std::invalid_argument);
    EXPECT_THROW(competences.tries(7), std::invalid_argument);
    EXPECT_THROW(competences.predict(0, -1, 1), std::invalid_argument);
    EXPECT_THROW(competences.predict(0, 1, -1), std::invalid_argument);
    EXPECT_THROW(Competences(std::vector<std::int32_t>{0, -1}, options_of("beta"), true),
                 std::invalid_argument);
    EXPECT_THROW(Competences(std::vector<std::int32_t>{0}, options_of("oracle"), true),
                 std::invalid_argument);
    EXPECT_THROW(Competences({}, options_of("beta", {0, 0}), true), std::invalid_argument);
    EXPECT_EQ(Competences({}, options_of("beta"), true).size(), 0u);
}

TEST(Competences, ShareWithinASchemaOnly) {
    Competences competences(std::vector<std::int32_t>{0, 0, 0, 1}, options_of("beta"), true);
    observe(competences, 0, 4, 1);
    observe(competences, 1, 3, 0);
    EXPECT_DOUBLE_EQ(competences.competence(2), 0.5) << "sharing is for the end of the cycle";
    competences.advance_cycle();
    const std::vector<Counts> siblings{{4, 1}, {3, 0}};
    const SharedPrior shared(siblings, {1, 1});
    EXPECT_EQ(competences.posterior(2), shared.prior());
    EXPECT_EQ(competences.posterior(0), shared.without(siblings[0]).after(siblings[0]));
    EXPECT_DOUBLE_EQ(competences.competence(3), 0.5);
    EXPECT_GT(competences.competence(2), 0.7);
    competences.observe(2, false);
    EXPECT_EQ(competences.posterior(2), shared.prior().after({0, 1})) << "and is where a first try starts";
}

TEST(Competences, WithoutSharingAreModelsOfTheirOwn) {
    for (const std::string name : {"beta", "optimistic", "latent"}) {
        Competences competences(std::vector<std::int32_t>{0, 0}, options_of(name), false);
        const auto model = make_competence_model(options_of(name));
        Random random(4);
        for (int i = 0; i < 60; ++i) {
            const bool success = random.below(3) == 0;
            competences.observe(0, success);
            model->observe(success);
            if (i % 7 == 0) {
                competences.advance_cycle();
                model->advance_cycle();
            }
            ASSERT_EQ(competences.posterior(0), model->posterior()) << name;
            ASSERT_EQ(competences.predict(0, 5, 1), model->predict(5, 1)) << name;
        }
        EXPECT_DOUBLE_EQ(competences.competence(1), 0.5) << name;
    }
}

TEST(Competences, AnOnlySkillIsTheSameWithSharing) {
    Competences shared(std::vector<std::int32_t>{0}, options_of("beta"), true);
    Competences alone(std::vector<std::int32_t>{0}, options_of("beta"), false);
    for (Competences* each : {&shared, &alone}) {
        observe(*each, 0, 5, 2);
        each->advance_cycle();
        observe(*each, 0, 1, 0);
        each->advance_cycle();
    }
    EXPECT_NEAR(shared.competence(0), alone.competence(0), 1e-9);
}

TEST(Competences, SharingHelpsEveryModel) {
    for (const std::string name : {"beta", "optimistic", "latent"}) {
        double alone_error = 0, shared_error = 0;
        Random random(9);
        for (int repetition = 0; repetition < 40; ++repetition) {
            constexpr std::size_t kSkills = 10;
            const std::vector<std::int32_t> schemas(kSkills, 0);
            Competences alone(schemas, options_of(name, {10, 1}), false);
            Competences shared(schemas, options_of(name, {10, 1}), true);
            const double mean = uniform(random, 0.1, 0.9);
            std::vector<double> truth(kSkills);
            for (double& competence : truth) competence = sample({20 * mean, 20 * (1 - mean)}, random);
            for (int cycle = 0; cycle < 3; ++cycle) {
                for (int i = 0; i < 15; ++i) {
                    const std::size_t skill = random.below(kSkills - 2);
                    const bool success = uniform(random) < truth[skill];
                    alone.observe(skill, success);
                    shared.observe(skill, success);
                }
                alone.advance_cycle();
                shared.advance_cycle();
            }
            for (std::size_t i = 0; i < kSkills; ++i) {
                alone_error += std::pow(alone.competence(i) - truth[i], 2);
                shared_error += std::pow(shared.competence(i) - truth[i], 2);
            }
        }
        std::printf("%-10s: alone %.3f, shared %.3f\n", name.c_str(), std::sqrt(alone_error / 400),
                    std::sqrt(shared_error / 400));
        EXPECT_LT(shared_error, 0.6 * alone_error) << name;
    }
}

RC_GTEST_PROP(Competences, AreDeterministic, ()) {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto run = [&] {
        Competences competences(std::vector<std::int32_t>{0, 0, 1, 1, 1}, options_of("latent"), true);
        Random random(seed);
        std::vector<double> answers;
        for (int i = 0; i < 40; ++i) {
            competences.observe(random.below(5), random.below(2) == 0, random.below(2) == 0);
            if (i % 10 == 9) competences.advance_cycle();
            for (std::size_t skill = 0; skill < 5; ++skill)
                answers.push_back(competences.predict(skill, 3, 1));
        }
        return answers;
    };
    RC_ASSERT(run() == run());
}

}  // namespace
}  // namespace praxis::practice
