#include "practice/competence/beta.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace praxis::practice {
namespace {

TEST(Beta, HasTheMomentsOfTheTextbook) {
    const Beta beta{3, 1};
    EXPECT_DOUBLE_EQ(beta.mean(), 0.75);
    EXPECT_DOUBLE_EQ(beta.variance(), 3.0 / 80);
    EXPECT_EQ(beta.after({2, 5}), (Beta{5, 6}));
}

TEST(Beta, RefusesWhatIsNoDistribution) {
    const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
    EXPECT_NO_THROW(check({0.5, 1e9}));
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_THROW(check({bad, 1}), std::invalid_argument) << bad;
        EXPECT_THROW(check({1, bad}), std::invalid_argument) << bad;
    }
}

TEST(Counts, Add) {
    Counts counts;
    counts.add(true);
    counts.add(false);
    counts.add(false);
    counts += {3, 4};
    EXPECT_EQ(counts, (Counts{4, 6}));
    EXPECT_EQ(counts.total(), 10);
}

}  // namespace
}  // namespace praxis::practice
