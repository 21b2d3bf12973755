#include "practice/policies/feature_selection.hpp"

#include <gtest/gtest.h>

#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

/// Eight numbers and a parameter; success is a matter of the third and the parameter.
Examples needle(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    Examples result;
    result.width = 9;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<double> row(9);
        for (double& value : row) value = uniform(random);
        for (const double value : row) result.rows.push_back(static_cast<float>(value));
        result.success.push_back(std::abs(row[2] - row[8]) < 0.2 ? 1 : 0);
    }
    return result;
}

TEST(SelectFeatures, FindsTheOneThatMatters) {
    int exact = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Random random(seed);
        const auto kept = select_features(needle(300, seed), 8, {}, random);
        EXPECT_TRUE(std::find(kept.begin(), kept.end(), 2u) != kept.end()) << seed;
        EXPECT_EQ(kept.back(), 8u);
        EXPECT_LE(kept.size(), 5u) << seed;
        exact += kept == std::vector<std::size_t>{2, 8} ? 1 : 0;
    }
    EXPECT_GE(exact, 3);
}

TEST(SelectFeatures, KeepsAllWithFewExamples) {
    Random random(1);
    EXPECT_EQ(select_features(needle(12, 1), 8, {}, random).size(), 9u);
}

TEST(SelectFeatures, SameSeedSameFeatures) {
    Random first(3);
    Random second(3);
    const Examples examples = needle(120, 2);
    EXPECT_EQ(select_features(examples, 8, {}, first), select_features(examples, 8, {}, second));
}

TEST(WithColumns, TakesThemInTheirOrder) {
    const Examples taken = with_columns({3, {1, 2, 3, 4, 5, 6}, {0, 1}}, {2, 0});
    EXPECT_EQ(taken.width, 2u);
    EXPECT_EQ(taken.rows, (std::vector<float>{3, 1, 6, 4}));
    EXPECT_EQ(taken.success, (std::vector<unsigned char>{0, 1}));
}

}  // namespace
}  // namespace praxis::practice
