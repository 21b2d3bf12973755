#include "practice/competence/beta_model.hpp"

#include <gtest/gtest.h>

#include "tests/practice/competence/support.hpp"

namespace praxis::practice {
namespace {

TEST(BetaModel, IsTheThesisRuleWithAUniformPrior) {
    BetaModel model({1, 1}, 0.1);
    observe(model, 3, 5);
    EXPECT_EQ(model.posterior(), (Beta{4, 6}));
    EXPECT_DOUBLE_EQ(model.competence(), 0.4);
    EXPECT_DOUBLE_EQ(model.predict(10, 1), 0.5);
}

TEST(BetaModel, LooksAtAllCyclesAlike) {
    BetaModel model({10, 1}, 0.5);
    cycle(model, 0, 4);
    cycle(model, 4, 1);
    EXPECT_DOUBLE_EQ(model.competence(), 14.0 / 20);
    EXPECT_EQ(model.evidence(), (Counts{4, 5}));
}

TEST(BetaModel, PredictsAtMostCertainty) {
    EXPECT_DOUBLE_EQ(BetaModel({10, 1}, 0.5).predict(0, 0), 1);
}

}  // namespace
}  // namespace praxis::practice
