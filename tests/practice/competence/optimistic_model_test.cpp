#include "practice/competence/optimistic_model.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

TEST(OptimisticModel, ExtrapolatesTheLargestChange) {
    OptimisticModel model({1, 1}, 5, 5, 0.5);
    cycle(model, 1, 9);  // 0.1
    cycle(model, 3, 7);  // 0.3
    cycle(model, 2, 8);  // 0.2
    EXPECT_DOUBLE_EQ(model.competence(), 7.0 / 32);
    EXPECT_DOUBLE_EQ(model.predict(99, 1), 7.0 / 32 + 0.2);
    EXPECT_DOUBLE_EQ(model.predict(0, 2), 7.0 / 32 + 0.4);
    EXPECT_DOUBLE_EQ(model.predict(0, 0), 7.0 / 32);
    EXPECT_DOUBLE_EQ(model.predict(0, 50), 1);
}

TEST(OptimisticModel, CountsAFallAsAChange) {
    OptimisticModel model({1, 1}, 1, 2, 0.5);
    cycle(model, 8, 2);
    cycle(model, 5, 5);
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 0.5 + 0.3);
}

TEST(OptimisticModel, TakesTheBonusUntilTwoCyclesHadOutcomes) {
    OptimisticModel model({1, 1}, 5, 5, 0.375);
    cycle(model, 1, 3);
    model.advance_cycle();
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 2.0 / 6 + 0.375);
    model.observe(false);
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 2.0 / 7 + 0.25);
}

TEST(OptimisticModel, WindowAndRecencyForgetApart) {
    OptimisticModel model({1, 1}, 1, 3, 0.5);
    cycle(model, 10, 0);
    cycle(model, 0, 10);
    cycle(model, 2, 8);
    cycle(model, 4, 6);
    EXPECT_EQ(model.evidence(), (Counts{4, 6}));
    EXPECT_DOUBLE_EQ(model.competence(), 5.0 / 12);
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 5.0 / 12 + 0.4);

    OptimisticModel wide({1, 1}, 3, 1, 0.5);
    cycle(wide, 10, 0);
    cycle(wide, 0, 10);
    cycle(wide, 2, 8);
    cycle(wide, 4, 6);
    EXPECT_DOUBLE_EQ(wide.competence(), 7.0 / 32);
    EXPECT_DOUBLE_EQ(wide.predict(0, 1), 7.0 / 32) << "one cycle shows no change";
}

TEST(OptimisticModel, OneCycleOfRecencyAndWindowStillKnowsThatThereWereTwo) {
    OptimisticModel model({1, 1}, 1, 1, 0.5);
    cycle(model, 0, 2);
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 0.75);
    cycle(model, 1, 1);
    EXPECT_DOUBLE_EQ(model.predict(0, 1), 0.5);
}

TEST(OptimisticModel, ThePresentCycleCountsOnceItHasAnOutcome) {
    OptimisticModel model({1, 1}, 1, 5, 0.5);
    cycle(model, 0, 8);
    EXPECT_DOUBLE_EQ(model.competence(), 0.1);
    model.observe(true);
    EXPECT_DOUBLE_EQ(model.competence(), 2.0 / 3);
}

TEST(OptimisticModel, AnEndlessWindowIsTheBetaModel) {
    const int all = std::numeric_limits<int>::max();
    OptimisticModel model({2, 3}, all, all, 0.5);
    for (int i = 0; i < 30; ++i) cycle(model, 1, 2);
    EXPECT_EQ(model.posterior(), (Beta{32, 63}));
}

}  // namespace
}  // namespace praxis::practice
