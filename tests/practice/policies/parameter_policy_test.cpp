#include "practice/policies/parameter_policy.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

/// One relevant feature (0), one that is noise (1), one parameter that succeeds near the relevant feature.
constexpr std::size_t kFeatures = 2;

ParameterPolicy policy(const PolicyOptions& options) {
    return ParameterPolicy(kFeatures, {0}, 1, options);
}

void practise(ParameterPolicy& policy, int trials, Random& random) {
    for (int i = 0; i < trials; ++i) {
        const State features{uniform(random), uniform(random)};
        const State parameters{uniform(random)};
        policy.observe(features, parameters, std::abs(features[0] - parameters[0]) < 0.15);
    }
}

double solved(const ParameterPolicy& policy, Random& random) {
    int successes = 0;
    for (int i = 0; i < 200; ++i) {
        const State features{uniform(random), uniform(random)};
        State candidates(100);
        for (double& candidate : candidates) candidate = uniform(random);
        successes +=
            std::abs(features[0] - candidates[policy.best(features, candidates, random)]) < 0.15 ? 1 : 0;
    }
    return successes / 200.0;
}

class Features : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(ParameterPolicy, Features, testing::Values("relevant", "all", "selected"));

TEST_P(Features, LearnsWhichParametersSucceed) {
    ParameterPolicy learner = policy({.features = GetParam()});
    Random random(1);
    EXPECT_LT(solved(learner, random), 0.5);
    practise(learner, 200, random);
    learner.learn(random);
    EXPECT_GE(solved(learner, random), 0.95);
    EXPECT_GT(learner.probability(State{0.5, 0.1}, State{0.5}), 0.7);
    EXPECT_LT(learner.probability(State{0.2, 0.1}, State{0.8}), 0.3);
}

TEST(ParameterPolicy, ChoosesAtRandomUntilBothOutcomesAreSeen) {
    ParameterPolicy learner = policy({});
    Random random(1);
    learner.observe(State{0, 0}, State{1}, false);
    learner.learn(random);
    EXPECT_EQ(learner.outcomes(), 1u);
    EXPECT_EQ(learner.probability(State{0, 0}, State{1}), 0.5);
    std::vector<int> chosen(4);
    for (int i = 0; i < 4000; ++i) ++chosen[learner.best(State{0, 0}, State{1, 2, 3, 4}, random)];
    for (const int times : chosen) EXPECT_NEAR(times, 1000, 150);
}

TEST(ParameterPolicy, ExploresWithProbabilityEpsilon) {
    ParameterPolicy learner = policy({.epsilon = 0.3});
    Random random(2);
    practise(learner, 200, random);
    learner.learn(random);
    const State features{0.5, 0.5};
    const State candidates{0.0, 0.5, 1.0};
    const std::size_t best = learner.best(features, candidates, random);
    EXPECT_EQ(best, 1u);
    int greedy = 0;
    std::vector<int> otherwise(3);
    for (int i = 0; i < 10'000; ++i) {
        const auto choice = learner.explore(features, candidates, random);
        if (choice.greedy) {
            EXPECT_EQ(choice.candidate, best);
            ++greedy;
        } else {
            ++otherwise[choice.candidate];
        }
    }
    EXPECT_NEAR(greedy, 7000, 200);
    for (const int times : otherwise) EXPECT_NEAR(times, 1000, 150);
}

TEST(ParameterPolicy, UncertainExplorationPrefersTheEdgeOfSuccess) {
    ParameterPolicy learner = policy({.exploration = "uncertain", .epsilon = 1});
    Random random(3);
    practise(learner, 300, random);
    learner.learn(random);
    const auto choice = learner.explore(State{0.5, 0.5}, State{0.5, 0.02, 0.65, 0.98}, random);
    EXPECT_EQ(choice.candidate, 2u);
    EXPECT_FALSE(choice.greedy);
}

TEST(ParameterPolicy, LearningAgainWithoutNewOutcomesChangesNothing) {
    ParameterPolicy learner = policy({});
    Random random(4);
    practise(learner, 60, random);
    learner.learn(random);
    const double before = learner.probability(State{0.3, 0.3}, State{0.45});
    learner.learn(random);
    EXPECT_EQ(before, learner.probability(State{0.3, 0.3}, State{0.45}));
}

TEST(ParameterPolicy, OfASkillWithoutParametersHasOneChoice) {
    ParameterPolicy learner(1, {0}, 0, {});
    Random random(5);
    learner.observe(State{1}, {}, true);
    learner.observe(State{2}, {}, false);
    learner.learn(random);
    EXPECT_EQ(learner.best(State{1}, {}, random), 0u);
    EXPECT_EQ(learner.explore(State{1}, {}, random).candidate, 0u);
}

TEST(ParameterPolicy, RefusesWrongUse) {
    ParameterPolicy learner = policy({});
    Random random(6);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(learner.observe(State{1}, State{1}, true), std::invalid_argument);
    EXPECT_THROW(learner.observe(State{1, 2}, State{1, 2}, true), std::invalid_argument);
    EXPECT_THROW(learner.observe(State{1, nan}, State{1}, true), std::invalid_argument);
    EXPECT_THROW(learner.observe(State{1, 1}, State{1e300}, true), std::invalid_argument);
    EXPECT_EQ(learner.outcomes(), 0u);
    EXPECT_THROW(learner.best(State{1, 2}, {}, random), std::invalid_argument);
    practise(learner, 60, random);
    learner.learn(random);
    EXPECT_THROW(learner.best(State{nan, 2}, State{1}, random), std::invalid_argument);
    EXPECT_THROW(learner.best(State{1}, State{1}, random), std::invalid_argument);
    EXPECT_THROW(policy({.candidates = 0}), std::invalid_argument);
    EXPECT_THROW(policy({.exploration = "boltzmann"}), std::invalid_argument);
    EXPECT_THROW(policy({.epsilon = nan}), std::invalid_argument);
    EXPECT_THROW(policy({.features = "some"}), std::invalid_argument);
    EXPECT_THROW(policy({.classifier = {.kind = "tree"}}), std::invalid_argument);
    EXPECT_THROW(ParameterPolicy(2, {2}, 1, {}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::practice
