#include "practice/policies/classifier.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "practice/policies/input_map.hpp"
#include "tests/practice/policies/skill_problems.hpp"

namespace praxis::practice {
namespace {

std::unique_ptr<Classifier> make(std::size_t width, const std::string& kind, bool differences = true) {
    ClassifierOptions options;
    options.kind = kind;
    options.differences = differences;
    return make_classifier(width, options);
}

std::vector<float> probabilities(const Classifier& classifier, const std::vector<float>& rows,
                                 std::size_t width) {
    std::vector<float> result(rows.size() / width);
    classifier.probabilities(rows, result);
    return result;
}

/// Mean success of the likeliest candidate over some sets of examples.
double chosen_success(const test::SkillProblem& problem, const std::string& kind, std::size_t count) {
    constexpr int kSets = 5;
    double sum = 0;
    for (std::uint64_t set = 0; set < kSets; ++set) {
        Random random(set);
        const Examples examples = test::examples(problem, count, random);
        const auto classifier = make(problem.width, kind);
        classifier->fit(examples, random);
        sum += test::success_of_best(problem, *classifier, 100, random);
    }
    return sum / kSets;
}

TEST(Classifier, LearnsToPlaceRelativeToTheDisc) {
    EXPECT_GE(chosen_success(test::relative_placing(), "mlp", 60), 0.98);
    EXPECT_GE(chosen_success(test::relative_placing(), "knn", 60), 0.9);
}

TEST(Classifier, LearnsToPlaceFromRawPositions) {
    EXPECT_GE(chosen_success(test::raw_placing(), "mlp", 250), 0.95);
    EXPECT_GE(chosen_success(test::raw_placing(), "ensemble", 120), 0.88);
}

TEST(Classifier, LearnsToDimFromFewSuccesses) {
    EXPECT_GE(chosen_success(test::dimming(), "mlp", 200), 0.85);
}

TEST(Classifier, LearnsExclusiveOr) {
    Examples examples;
    examples.width = 2;
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const double x = uniform(random, -1, 1);
        const double y = uniform(random, -1, 1);
        examples.rows.insert(examples.rows.end(), {static_cast<float>(x), static_cast<float>(y)});
        examples.success.push_back((x > 0) != (y > 0) ? 1 : 0);
    }
    const auto classifier = make(2, "mlp");
    classifier->fit(examples, random);
    const auto result = probabilities(*classifier, {0.5f, 0.5f, 0.5f, -0.5f, -0.5f, 0.5f, -0.5f, -0.5f}, 2);
    EXPECT_LT(result[0], 0.2);
    EXPECT_GT(result[1], 0.8);
    EXPECT_GT(result[2], 0.8);
    EXPECT_LT(result[3], 0.2);
}

class Kinds : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Classifier, Kinds, testing::Values("mlp", "knn", "ensemble"));

TEST_P(Kinds, SameExamplesAndSeedGiveTheSameClassifier) {
    Random draw(1);
    const test::SkillProblem problem = test::dimming();
    const Examples earlier = test::examples(problem, 30, draw);
    const Examples examples = test::examples(problem, 60, draw);
    const auto fresh = make(problem.width, GetParam());
    const auto used = make(problem.width, GetParam());
    Random random(9);
    used->fit(earlier, random);
    Random first(2);
    Random second(2);
    fresh->fit(examples, first);
    used->fit(examples, second);
    EXPECT_EQ(probabilities(*fresh, examples.rows, problem.width),
              probabilities(*used, examples.rows, problem.width));
}

TEST_P(Kinds, RefusesOneOutcomeAlone) {
    const auto classifier = make(1, GetParam());
    Random random(1);
    EXPECT_THROW(classifier->fit({1, {1, 2, 3}, {1, 1, 1}}, random), std::invalid_argument);
    EXPECT_THROW(classifier->fit({1, {1, 2, 3}, {0, 0, 0}}, random), std::invalid_argument);
    EXPECT_THROW(classifier->fit({1, {}, {}}, random), std::invalid_argument);
}

TEST_P(Kinds, RefusesWhatIsNotFiniteOrDoesNotFit) {
    const auto classifier = make(1, GetParam());
    Random random(1);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
        EXPECT_THROW(classifier->fit({1, {1, bad}, {0, 1}}, random), std::invalid_argument);
    EXPECT_THROW(classifier->fit({1, {1, 2, 3}, {0, 1}}, random), std::invalid_argument);
    EXPECT_THROW(classifier->fit({2, {1, 2, 3, 4}, {0, 1}}, random), std::invalid_argument);
}

TEST_P(Kinds, GivesProbabilitiesOfConstantAndHugeNumbers) {
    const auto classifier = make(2, GetParam());
    Random random(1);
    classifier->fit({2, {7, 1e30f, 7, -1e30f, 7, 3e38f, 7, -3e38f}, {0, 1, 0, 1}}, random);
    for (const float p : probabilities(*classifier, {7, 0, 1e38f, -3e38f, -1, 3e38f}, 2)) {
        EXPECT_GE(p, 0);
        EXPECT_LE(p, 1);
    }
    classifier->fit({2, {7, 7, 7, 7}, {0, 1}}, random);
    EXPECT_NEAR(probabilities(*classifier, {7, 7}, 2)[0], 0.5, 0.2);
}

TEST_P(Kinds, IsUnsureWhereOutcomesMix) {
    Examples examples;
    examples.width = 1;
    Random random(4);
    for (int i = 0; i < 300; ++i) {
        const double x = uniform(random, -1, 1);
        examples.rows.push_back(static_cast<float>(x));
        examples.success.push_back(x > 0.1 || (x > -0.1 && random.below(2) == 0) ? 1 : 0);
    }
    const auto classifier = make(1, GetParam());
    classifier->fit(examples, random);
    std::vector<float> rows;
    for (int i = -9; i <= 9; ++i) rows.push_back(static_cast<float>(i) * 0.01f);
    rows.insert(rows.end(), {0.9f, -0.9f});
    std::vector<float> unsure(rows.size());
    classifier->uncertainties(rows, unsure);
    const float in_the_middle = *std::max_element(unsure.begin(), unsure.end() - 2);
    EXPECT_GT(in_the_middle, unsure[rows.size() - 2]);
    EXPECT_GT(in_the_middle, unsure[rows.size() - 1]);
}

TEST(EnsembleClassifier, OfOneMemberDisagreesOnNothing) {
    ClassifierOptions options;
    options.kind = "ensemble";
    options.members = 1;
    const auto classifier = make_classifier(3, options);
    Random random(1);
    const Examples examples = test::examples(test::dimming(), 50, random);
    classifier->fit(examples, random);
    std::vector<float> unsure(examples.size());
    classifier->uncertainties(examples.rows, unsure);
    for (const float value : unsure) EXPECT_NEAR(value, 0, 1e-6);
}

RC_GTEST_PROP(KnnClassifier, IsBruteForce, ()) {
    const auto width = *rc::gen::inRange<std::size_t>(1, 5);
    const auto count = *rc::gen::inRange<std::size_t>(2, 40);
    ClassifierOptions options;
    options.kind = "knn";
    options.neighbours = *rc::gen::inRange(1, 50);
    options.differences = *rc::gen::arbitrary<bool>();
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Examples examples;
    examples.width = width;
    for (std::size_t i = 0; i < count * width; ++i)
        examples.rows.push_back(static_cast<float>(random.below(5)));  // many are equally far
    for (std::size_t i = 0; i < count; ++i)
        examples.success.push_back(i < 2 ? static_cast<unsigned char>(i) : random.below(2) != 0);
    const auto classifier = make_classifier(width, options);
    classifier->fit(examples, random);

    const InputMap map(examples, options.differences);
    std::vector<float> inputs(count * map.size());
    map.apply(examples.rows, inputs);
    const std::vector<float> found = probabilities(*classifier, examples.rows, width);
    for (std::size_t q = 0; q < count; ++q) {
        std::vector<std::pair<float, std::size_t>> order;
        for (std::size_t r = 0; r < count; ++r) {
            float distance = 0;
            for (std::size_t i = 0; i < map.size(); ++i) {
                const float away = inputs[r * map.size() + i] - inputs[q * map.size() + i];
                distance += away * away;
            }
            order.emplace_back(distance, r);
        }
        std::sort(order.begin(), order.end());
        const std::size_t nearest = std::min(count, static_cast<std::size_t>(options.neighbours));
        int successes = 0;
        for (std::size_t k = 0; k < nearest; ++k) successes += examples.success[order[k].second];
        RC_ASSERT(found[q] == static_cast<float>(successes) / static_cast<float>(nearest));
    }
}

TEST(InputMap, StandardisesNumbersAndDifferencesAndDropsConstants) {
    const Examples examples{3, {1, 5, 2, 3, 5, 0}, {0, 1}};
    const InputMap plain(examples, false);
    EXPECT_EQ(plain.size(), 2u);
    const InputMap map(examples, true);
    ASSERT_EQ(map.size(), 3u);
    std::vector<float> inputs(6);
    map.apply(examples.rows, inputs);
    EXPECT_EQ(inputs, (std::vector<float>{-1, 1, 1, 1, -1, -1}));  // the last: third number less the first
}

TEST(InputMap, RoundingIsNotVariation) {
    const InputMap map({2, {100, 1, 100.00001f, 2, 99.99999f, 3}, {0, 1, 1}}, true);
    EXPECT_EQ(map.size(), 1u);
}

TEST(MakeClassifier, NamesTheKindsAndRefusesOptionsOutOfRange) {
    const auto refused = [](auto change) {
        ClassifierOptions options;
        change(options);
        EXPECT_THROW(make_classifier(2, options), std::invalid_argument);
    };
    refused([](ClassifierOptions& o) { o.kind = "tree"; });
    refused([](ClassifierOptions& o) { o.steps = 0; });
    refused([](ClassifierOptions& o) { o.learning_rate = std::numeric_limits<double>::quiet_NaN(); });
    refused([](ClassifierOptions& o) { o.weight_decay = -1; });
    refused([](ClassifierOptions& o) { o.weight_decay = 1e9; });
    refused([](ClassifierOptions& o) { o.neighbours = 0; });
    refused([](ClassifierOptions& o) { o.members = 0; });
    refused([](ClassifierOptions& o) { o.hidden = {0}; });
    try {
        make_classifier(2, {.kind = "tree"});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(), "no classifier 'tree'; there are mlp, knn, ensemble");
    }
}

}  // namespace
}  // namespace praxis::practice
