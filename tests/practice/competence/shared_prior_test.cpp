#include "practice/competence/shared_prior.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

/// What the fixed point climbs, by the definition.
double objective(const std::vector<Counts>& siblings, const Beta& base, const Beta& beta) {
    const double a = beta.successes, b = beta.failures;
    double sum = base.successes * std::log(a) - a + base.failures * std::log(b) - b;
    for (const Counts& counts : siblings) {
        const auto s = static_cast<double>(counts.successes), f = static_cast<double>(counts.failures);
        sum += std::lgamma(a + s) - std::lgamma(a) + std::lgamma(b + f) - std::lgamma(b) -
               std::lgamma(a + b + s + f) + std::lgamma(a + b);
    }
    return sum;
}

std::vector<Counts> random_siblings() {
    std::vector<Counts> siblings(*rc::gen::inRange<std::size_t>(1, 12));
    for (Counts& counts : siblings) counts = {*rc::gen::inRange(0, 60), *rc::gen::inRange(0, 60)};
    return siblings;
}

Beta random_base() {
    return {*rc::gen::inRange(5, 200) / 10.0, *rc::gen::inRange(5, 200) / 10.0};
}

TEST(SharedPrior, WithoutOutcomesIsTheBase) {
    EXPECT_EQ(shared_prior({}, {10, 1}), (Beta{10, 1}));
    EXPECT_EQ(shared_prior(std::vector<Counts>(3), {10, 1}), (Beta{10, 1}));
}

TEST(SharedPrior, OneOutcomeMovesTheMeanAsBayesDoesAndLeavesTheStrength) {
    const Beta success = shared_prior(std::vector<Counts>{{1, 0}}, {1, 1});
    EXPECT_NEAR(success.successes, 4.0 / 3, 1e-4);
    EXPECT_NEAR(success.failures, 2.0 / 3, 1e-4);
    const Beta failure = shared_prior(std::vector<Counts>{{0, 1}}, {10, 1});
    EXPECT_NEAR(failure.mean(), 10.0 / 12, 1e-4);
    EXPECT_NEAR(failure.strength(), 11, 1e-3);
}

TEST(SharedPrior, TwoSkillsThatNeverFailOrAlwaysDoSplitTheMean) {
    const Beta prior = shared_prior(std::vector<Counts>{{50, 0}, {0, 50}}, {1, 1});
    EXPECT_NEAR(prior.mean(), 0.5, 1e-9);
    EXPECT_LT(prior.strength(), 1.5) << "siblings that differ are no guide";
}

TEST(SharedPrior, ManySkillsThatAgreeAreAStrongPrior) {
    const Beta prior = shared_prior(std::vector<Counts>(40, Counts{15, 5}), {1, 1});
    EXPECT_NEAR(prior.mean(), 0.75, 0.02);
    EXPECT_GT(prior.strength(), 8);
}

TEST(SharedPrior, AnOnlyChildLearnsNothingFromItself) {
    const Counts counts{13, 4};
    const Beta prior = SharedPrior(std::vector<Counts>{counts}, {3, 2}).without(counts);
    EXPECT_NEAR(prior.successes, 3, 1e-9);
    EXPECT_NEAR(prior.failures, 2, 1e-9);
}

TEST(SharedPrior, RefusesWhatAreNoCounts) {
    EXPECT_THROW(shared_prior(std::vector<Counts>{{-1, 2}}, {1, 1}), std::invalid_argument);
    EXPECT_THROW(shared_prior({}, {1, 0}), std::invalid_argument);
}

TEST(SharedPrior, StaysADistributionForExtremes) {
    for (const Beta base : {Beta{1e-9, 1e9}, Beta{1e12, 1e12}, Beta{1e-12, 1e-12}})
        for (const Counts counts : {Counts{1000000000000, 0}, Counts{0, 1000000}, Counts{1, 1}}) {
            const std::vector<Counts> siblings(5, counts);
            const SharedPrior shared(siblings, base);
            EXPECT_NO_THROW(check(shared.prior()));
            EXPECT_NO_THROW(check(shared.without(counts)));
        }
}

RC_GTEST_PROP(SharedPrior, IsAMaximum, ()) {
    const std::vector<Counts> siblings = random_siblings();
    const Beta base = random_base(), prior = shared_prior(siblings, base);
    const double best = objective(siblings, base, prior);
    RC_ASSERT(best >= objective(siblings, base, base) - 1e-9);
    for (const double factor : {0.5, 0.8, 0.95, 1.05, 1.25, 2.0})
        for (const double other : {0.5, 0.8, 0.95, 1.0, 1.05, 1.25, 2.0}) {
            const Beta near{prior.successes * factor, prior.failures * other};
            RC_ASSERT(objective(siblings, base, near) <= best + 1e-3);
        }
}

RC_GTEST_PROP(SharedPrior, IsSymmetric, ()) {
    std::vector<Counts> siblings = random_siblings();
    const Beta base = random_base(), prior = shared_prior(siblings, base);
    for (Counts& counts : siblings) std::swap(counts.successes, counts.failures);
    const Beta mirrored = shared_prior(siblings, {base.failures, base.successes});
    RC_ASSERT(std::abs(mirrored.successes - prior.failures) < 1e-9 * prior.failures);
    RC_ASSERT(std::abs(mirrored.failures - prior.successes) < 1e-9 * prior.successes);
}

RC_GTEST_PROP(SharedPrior, WithoutASiblingFitsTheOthersNoWorse, ()) {
    std::vector<Counts> siblings = random_siblings();
    const Beta base = random_base();
    const SharedPrior shared(siblings, base);
    const Beta without = shared.without(siblings.back());
    siblings.pop_back();
    RC_ASSERT(objective(siblings, base, without) >= objective(siblings, base, shared.prior()) - 1e-7);
}

struct Sharing {
    double alone = 0, shared = 0;  ///< root mean squared errors of competences
};

/// Schemas whose skills have competences ~ Beta(mean strength, ...), mean ~ U(0.1, 0.9), 1..10 outcomes each.
void measure(const Beta& base, double strength, std::size_t siblings, Sharing& tried, Sharing& untried) {
    constexpr int kSchemas = 400;
    Random random(15);
    const auto add = [](Sharing& sum, double alone, double shared, double truth) {
        sum.alone += std::pow(alone - truth, 2);
        sum.shared += std::pow(shared - truth, 2);
    };
    for (int schema = 0; schema < kSchemas; ++schema) {
        const double mean = uniform(random, 0.1, 0.9);
        const Beta family{mean * strength, (1 - mean) * strength};
        std::vector<double> truth(siblings);
        std::vector<Counts> counts(siblings);
        for (std::size_t i = 0; i < siblings; ++i) {
            truth[i] = sample(family, random);
            for (std::size_t n = 1 + random.below(10); n > 0; --n) counts[i].add(uniform(random) < truth[i]);
        }
        const SharedPrior shared(counts, base);
        for (std::size_t i = 0; i < siblings; ++i)
            add(tried, base.after(counts[i]).mean(), shared.without(counts[i]).after(counts[i]).mean(),
                truth[i]);
        add(untried, base.mean(), shared.prior().mean(), sample(family, random));
    }
    for (Sharing* sum : {&tried, &untried}) {
        const double answers = kSchemas * (sum == &tried ? static_cast<double>(siblings) : 1);
        *sum = {std::sqrt(sum->alone / answers), std::sqrt(sum->shared / answers)};
    }
}

TEST(SharedPrior, LowersTheErrorOfCompetences) {
    for (const Beta base : {Beta{10, 1}, Beta{1, 1}})
        for (const double strength : {2, 8, 30})
            for (const std::size_t siblings : {2u, 5u, 20u}) {
                Sharing tried, untried;
                measure(base, strength, siblings, tried, untried);
                std::printf(
                    "base Beta(%g, %g), strength %2g, %2zu siblings: tried %.3f -> %.3f, untried %.3f -> "
                    "%.3f\n",
                    base.successes, base.failures, strength, siblings, tried.alone, tried.shared,
                    untried.alone, untried.shared);
                EXPECT_LT(tried.shared, 0.98 * tried.alone);
                EXPECT_LT(untried.shared, 0.98 * untried.alone);
                if (siblings < 20) continue;
                EXPECT_LT(tried.shared, 0.93 * tried.alone);
                EXPECT_LT(untried.shared, 0.85 * untried.alone);
            }
}

}  // namespace
}  // namespace praxis::practice
