// Gradients against finite differences, passes against the plainest loops.
#include "practice/policies/mlp.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "practice/environment.hpp"
#include "practice/policies/adam.hpp"
#include "practice/policies/matrix_product.hpp"

namespace praxis::practice {
namespace {

std::vector<float> numbers(std::size_t count, Random& random) {
    std::vector<float> result(count);
    for (float& value : result) value = static_cast<float>(uniform(random, -1, 1));
    return result;
}

RC_GTEST_PROP(MatrixProduct, IsTheSumOfProducts, ()) {
    const auto rows = *rc::gen::inRange<std::size_t>(0, 12);
    const auto inner = *rc::gen::inRange<std::size_t>(0, 9);
    const auto columns = *rc::gen::inRange<std::size_t>(1, 40);
    const bool transposed = *rc::gen::arbitrary<bool>();
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const std::vector<float> a = numbers(rows * inner, random);
    const std::vector<float> b = numbers(inner * columns, random);
    const std::vector<float> before = numbers(rows * columns, random);
    std::vector<float> c = before;
    const StridedMatrix strided{a.data(), transposed ? 1 : inner, transposed ? rows : 1};
    add_product(strided, b.data(), c.data(), rows, inner, columns);
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            double expected = before[i * columns + j];
            for (std::size_t k = 0; k < inner; ++k)
                expected += double{a[i * strided.row_step + k * strided.column_step]} * b[k * columns + j];
            RC_ASSERT(std::abs(expected - c[i * columns + j]) < 1e-5);
        }
}

TEST(Mlp, LinearModelByHand) {
    Mlp network(2, {}, 2);
    const std::vector<float> weights = {1, 2, 3, 4, 10, 20};
    std::copy(weights.begin(), weights.end(), network.weights().begin());
    std::vector<float> outputs(4);
    network.evaluate(std::vector<float>{1, 0, 2, -1}, outputs);
    EXPECT_EQ(outputs, (std::vector<float>{11, 22, 9, 20}));
}

TEST(Mlp, HiddenUnitsAreRectified) {
    Mlp network(1, {1}, 1);
    const std::vector<float> weights = {1, 0, 1, 5};
    std::copy(weights.begin(), weights.end(), network.weights().begin());
    std::vector<float> outputs(2);
    network.evaluate(std::vector<float>{2, -2}, outputs);
    EXPECT_EQ(outputs, (std::vector<float>{7, 5}));
}

TEST(Mlp, InitiallyZeroWithRandomHiddenWeights) {
    Mlp network(3, {8}, 1);
    Random random(1);
    network.initialise(random);
    std::vector<float> output(1);
    network.evaluate(std::vector<float>{1, 2, 3}, output);
    EXPECT_EQ(output[0], 0);
    EXPECT_NE(network.weights()[0], network.weights()[1]);
}

TEST(Mlp, EvaluatesMoreRowsThanABatch) {
    Random random(3);
    Mlp network(2, {5}, 1);
    for (float& weight : network.weights()) weight = static_cast<float>(uniform(random, -1, 1));
    const std::vector<float> rows = numbers(2 * 150, random);
    std::vector<float> all(150);
    network.evaluate(rows, all);
    for (std::size_t r : {0u, 63u, 64u, 149u}) {
        std::vector<float> one(1);
        network.evaluate(std::span<const float>(rows).subspan(2 * r, 2), one);
        EXPECT_FLOAT_EQ(one[0], all[r]) << r;
    }
}

RC_GTEST_PROP(Mlp, GradientIsTheFiniteDifference, ()) {
    const std::size_t width = *rc::gen::inRange<std::size_t>(1, 6);
    const std::size_t outputs = *rc::gen::inRange<std::size_t>(1, 4);
    const auto layers = *rc::gen::inRange<std::size_t>(0, 4);
    const auto hidden =
        *rc::gen::container<std::vector<std::size_t>>(layers, rc::gen::inRange<std::size_t>(1, 20));
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    constexpr std::size_t kRows = 5;
    Mlp network(width, hidden, outputs);
    for (float& weight : network.weights()) weight = static_cast<float>(uniform(random, -1, 1));
    const std::vector<float> rows = numbers(kRows * width, random);
    const std::vector<float> by_output = numbers(kRows * outputs, random);
    const auto loss = [&] {
        std::vector<float> result(kRows * outputs);
        network.evaluate(rows, result);
        double sum = 0;
        for (std::size_t i = 0; i < result.size(); ++i) sum += double{result[i]} * by_output[i];
        return sum;
    };
    Mlp::Workspace workspace(network, kRows);
    network.forward(rows, workspace);
    std::vector<float> gradient(network.weights().size());
    network.backward(rows, by_output, workspace, gradient);
    const double here = loss();
    const double scale = 1 + std::abs(here);
    for (int tried = 0; tried < 10; ++tried) {
        const std::size_t w = random.below(gradient.size());
        const float weight = network.weights()[w];
        bool straight = true;  // no unit changes sides: the loss is linear in the weight
        double slope = 0;
        for (const float step : {2e-2f, 1e-2f}) {
            network.weights()[w] = weight + step;
            const double above = loss();
            network.weights()[w] = weight - step;
            const double below = loss();
            straight = straight && std::abs(above - 2 * here + below) < 1e-5 * scale;
            slope = (above - below) / (2 * step);
        }
        network.weights()[w] = weight;
        if (straight) RC_ASSERT(std::abs(slope - gradient[w]) < 1e-2 * scale);
    }
}

TEST(Mlp, RefusesALayerWithoutUnits) {
    EXPECT_THROW(Mlp(3, {4, 0}, 1), std::invalid_argument);
    EXPECT_THROW(Mlp(3, {4}, 0), std::invalid_argument);
}

TEST(Adam, FirstStepIsTheRateInTheGradientsDirection) {
    Adam adam(2);
    std::vector<float> weights = {1, 1};
    adam.step(weights, std::vector<float>{0.5f, -20}, 0.1f, 0);
    EXPECT_NEAR(weights[0], 0.9, 1e-5);
    EXPECT_NEAR(weights[1], 1.1, 1e-5);
}

TEST(Adam, DecayShrinksWeightsWithoutAGradient) {
    Adam adam(1);
    std::vector<float> weights = {2};
    adam.step(weights, std::vector<float>{0}, 0.1f, 0.5f);
    EXPECT_FLOAT_EQ(weights[0], 1.9f);
}

TEST(Adam, FindsTheMinimumOfASquare) {
    Adam adam(1);
    std::vector<float> weights = {4};
    for (int step = 0; step < 500; ++step)
        adam.step(weights, std::vector<float>{2 * (weights[0] - 1)}, 0.05f, 0);
    EXPECT_NEAR(weights[0], 1, 1e-2);
}

}  // namespace
}  // namespace praxis::practice
