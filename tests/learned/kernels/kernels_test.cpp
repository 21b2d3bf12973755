#include "learned/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "learned/kernels/interleaved.hpp"
#include "learned/kernels/row_pairs.hpp"
#include "tests/learned/support/fields.hpp"

namespace praxis::learned {
namespace {

template <class T>
std::vector<T> random_weights(std::size_t count, Random& random) {
    std::vector<T> weights(count);
    for (T& weight : weights) weight = static_cast<T>(uniform(random, -1, 1));
    return weights;
}

/// The definition of a convolution, cell by cell.
template <class T>
void convolve_plainly(const ConvolutionShape& shape, const Planes<T>& input, const std::vector<T>& filter,
                      Planes<T>& output) {
    const int side = 2 * shape.radius + 1;
    for (int o = 0; o < shape.outputs; ++o)
        for (int row = 0; row < shape.height; ++row)
            for (int column = 0; column < shape.width; ++column)
                for (int i = 0; i < shape.inputs; ++i)
                    for (int t = 0; t < side * side; ++t)
                        output.at(o, row, column) +=
                            filter[static_cast<std::size_t>((i * side * side + t) * shape.outputs + o)] *
                            input.at(i, row + t / side - shape.radius, column + t % side - shape.radius);
}

struct Case {
    Instructions instructions;
    int height, width, radius, inputs, outputs;
};

std::vector<Case> cases() {
    std::vector<Case> result;
    for (const Instructions instructions :
         {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
        if (!supported(instructions)) continue;
        for (const auto& [height, width] : {std::pair{15, 15}, {4, 16}, {7, 33}, {1, 1}, {17, 5}})
            for (const int radius : {0, 1, 2})
                for (const auto& [inputs, outputs] : {std::pair{1, 10}, {8, 3}, {2, 7}, {3, 1}})
                    result.push_back({instructions, height, width, radius, inputs, outputs});
    }
    return result;
}

template <class T>
class KernelTest : public testing::Test {
  public:
    static constexpr double kError = sizeof(T) == 4 ? 1e-4 : 1e-12;
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(KernelTest, Reals);

TYPED_TEST(KernelTest, ConvolutionAgreesWithItsDefinitionAndAddsToTheOutput) {
    using T = TypeParam;
    Random random(1);
    for (const Case& c : cases()) {
        const ConvolutionShape shape{c.height, c.width, c.radius, c.inputs, c.outputs};
        Planes<T> input(c.inputs, c.height, c.width, c.radius), output(c.outputs, c.height, c.width, 1),
            expected = output;
        randomise(input, random);
        input.pad(Padding::circular);
        randomise(output, random);
        for (int o = 0; o < c.outputs; ++o)
            for (int row = 0; row < c.height; ++row)
                for (int column = 0; column < c.width; ++column)
                    expected.at(o, row, column) = output.at(o, row, column);
        const std::vector<T> filter = random_weights<T>(shape.weights(), random);
        convolve_plainly(shape, input, filter, expected);
        kernels<T>(c.instructions).convolve(shape, input.view(), filter.data(), output.view());
        EXPECT_LE(largest_difference(output, expected), this->kError)
            << kernels<T>(c.instructions).name << " " << c.height << "x" << c.width << " radius " << c.radius;
        for (int o = 0; o < c.outputs; ++o)
            for (int row = 0; row < c.height; ++row) EXPECT_EQ(output.at(o, row, c.width), T(0));
    }
}

TYPED_TEST(KernelTest, GradientOfTheFilterIsTheTransposeOfConvolution) {
    using T = TypeParam;
    Random random(2);
    for (const Case& c : cases()) {
        const ConvolutionShape shape{c.height, c.width, c.radius, c.inputs, c.outputs};
        Planes<T> input(c.inputs, c.height, c.width, c.radius), of_output(c.outputs, c.height, c.width, 0);
        randomise(input, random);
        input.pad(Padding::zero);
        randomise(of_output, random);
        std::vector<T> gradient(shape.weights());
        kernels<T>(c.instructions).convolve_gradient(shape, input.view(), of_output.view(), gradient.data());
        // Convolution is linear in its filter: <of_output, convolve(e_j)> is the gradient's entry j.
        for (std::size_t j = 0; j < gradient.size(); j += 1 + gradient.size() / 7) {
            std::vector<T> unit(gradient.size());
            unit[j] = 1;
            Planes<T> output(c.outputs, c.height, c.width, 0);
            convolve_plainly(shape, input, unit, output);
            EXPECT_NEAR(static_cast<double>(gradient[j]), dot(of_output, output), this->kError);
        }
    }
}

struct Backup {
    BackupShape shape;
    Padding padding;
};

std::vector<Backup> backups() {
    std::vector<Backup> result;
    for (const Padding padding : {Padding::zero, Padding::circular})
        for (const int radius : {1, 2})
            for (const auto& [order, fields] : {std::pair{1, 10}, {4, 3}, {8, 8}, {8, 1}})
                for (const auto& [height, width] : {std::pair{15, 15}, {6, 17}})
                    result.push_back({{height, width, radius, order, fields}, padding});
    return result;
}

TYPED_TEST(KernelTest, BackupIsTheMaximumOverFieldsAndRecordsWhere) {
    using T = TypeParam;
    Random random(3);
    for (const Instructions instructions :
         {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
        if (!supported(instructions)) continue;
        for (const auto& [shape, padding] : backups()) {
            const int outputs = shape.order * shape.fields;
            Planes<T> values(shape.order, shape.height, shape.width, shape.radius), result = values,
                                                                                    plain = values;
            Planes<T> rewards(outputs, shape.height, shape.width, 0);
            randomise(values, random);
            values.pad(padding);
            randomise(rewards, random);
            const ConvolutionShape dense{shape.height, shape.width, shape.radius, shape.order, outputs};
            const std::vector<T> filter = random_weights<T>(dense.weights(), random);
            std::vector<std::uint8_t> best(static_cast<std::size_t>(rewards.plane() * shape.order));
            const Kernels<T>& k = kernels<T>(instructions);
            k.backup(shape, values.view(), filter.data(), rewards.view(), result.view(), best.data());
            k.backup(shape, values.view(), filter.data(), rewards.view(), plain.view(), nullptr);
            EXPECT_EQ(largest_difference(result, plain), 0);
            if (shape.radius == 1) {
                std::vector<T> paired, scratch(row_pair_scratch(shape, values.stride()));
                pair_filter(shape.order, outputs, std::span<const T>(filter), paired);
                std::vector<std::uint8_t> best_of_pairs(best.size());
                Planes<T> by_pairs = values;
                k.backup_by_pairs(shape, values.view(), paired.data(), rewards.view(), by_pairs.view(),
                                  nullptr, scratch.data());
                EXPECT_LE(largest_difference(by_pairs, result), this->kError);
                k.backup_by_pairs(shape, values.view(), paired.data(), rewards.view(), by_pairs.view(),
                                  best_of_pairs.data(), scratch.data());
                EXPECT_LE(largest_difference(by_pairs, result), this->kError);
                std::size_t others = 0;  // rounding may break ties in another way
                for (int h = 0; h < shape.order; ++h)
                    for (int row = 0; row < shape.height; ++row)
                        for (int column = 0; column < shape.width; ++column) {
                            const auto at = static_cast<std::size_t>(h * rewards.plane() +
                                                                     row * rewards.stride() + column);
                            others += best[at] != best_of_pairs[at];
                        }
                EXPECT_LE(others, best.size() / 100);
            }
            Planes<T> q = rewards;
            convolve_plainly(dense, values, filter, q);
            for (int h = 0; h < shape.order; ++h)
                for (int row = 0; row < shape.height; ++row)
                    for (int column = 0; column < shape.width; ++column) {
                        T largest = q.at(h * shape.fields, row, column);
                        for (int f = 1; f < shape.fields; ++f)
                            largest = std::max(largest, q.at(h * shape.fields + f, row, column));
                        EXPECT_NEAR(result.at(h, row, column), largest, this->kError);
                        const int f = best[static_cast<std::size_t>(h * rewards.plane() +
                                                                    row * rewards.stride() + column)];
                        ASSERT_LT(f, shape.fields);
                        EXPECT_NEAR(q.at(h * shape.fields + f, row, column), largest, this->kError);
                    }
        }
    }
}

TYPED_TEST(KernelTest, GradientOfABackupIsTheTransposeOfItsFilterAtTheMaximisers) {
    using T = TypeParam;
    Random random(4);
    for (const Instructions instructions :
         {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
        if (!supported(instructions)) continue;
        for (const auto& [shape, padding] : backups()) {
            const int outputs = shape.order * shape.fields, taps = shape.taps();
            Planes<T> values(shape.order, shape.height, shape.width, shape.radius), of_result = values;
            randomise(values, random);
            values.pad(padding);
            randomise(of_result, random);
            const ConvolutionShape dense{shape.height, shape.width, shape.radius, shape.order, outputs};
            const std::vector<T> filter = random_weights<T>(dense.weights(), random);
            std::vector<T> turned(filter.size()), of_turned(filter.size());
            for (int i = 0; i < shape.order; ++i)
                for (int t = 0; t < taps; ++t)
                    for (int o = 0; o < outputs; ++o)
                        turned[static_cast<std::size_t>((o * taps + t) * shape.order + i)] =
                            filter[static_cast<std::size_t>((i * taps + t) * outputs + o)];
            Planes<T> of_rewards(outputs, shape.height, shape.width, 0), of_q = of_rewards;
            std::vector<std::uint8_t> best(static_cast<std::size_t>(of_rewards.plane() * shape.order));
            for (std::uint8_t& f : best)
                f = static_cast<std::uint8_t>(random.below(static_cast<std::size_t>(shape.fields)));
            for (int h = 0; h < shape.order; ++h)
                for (int row = 0; row < shape.height; ++row)
                    for (int column = 0; column < shape.width; ++column) {
                        const int f =
                            best[static_cast<std::size_t>(h * of_q.plane() + row * of_q.stride() + column)];
                        of_q.at(h * shape.fields + f, row, column) = of_result.at(h, row, column);
                    }
            Interleaved<T> by_cell(shape.order, shape.height, shape.width, shape.radius),
                result_by_cell = by_cell, of_values = by_cell;
            by_cell.gather(values);
            result_by_cell.gather(of_result);
            kernels<T>(instructions)
                .backup_gradient(shape, by_cell.view(), turned.data(), best.data(), result_by_cell.view(),
                                 of_values.view(), of_turned.data(), of_rewards.view());
            of_values.fold(padding);
            EXPECT_LE(largest_difference(of_rewards, of_q), this->kError);
            // <of_q, filter(direction)> = <of_values, direction> for any direction.
            Planes<T> direction = values, image(outputs, shape.height, shape.width, 0);
            randomise(direction, random);
            direction.pad(padding);
            convolve_plainly(dense, direction, filter, image);
            double product = 0;
            for (int h = 0; h < shape.order; ++h)
                for (int row = 0; row < shape.height; ++row)
                    for (int column = 0; column < shape.width; ++column)
                        product +=
                            static_cast<double>(of_values.at(row, column)[h] * direction.at(h, row, column));
            EXPECT_NEAR(product, dot(of_q, image), 10 * this->kError);
            std::vector<T> expected(filter.size());
            kernels<T>(Instructions::portable)
                .convolve_gradient(dense, values.view(), of_q.view(), expected.data());
            for (int i = 0; i < shape.order; ++i)
                for (int t = 0; t < taps; ++t)
                    for (int o = 0; o < outputs; ++o)
                        EXPECT_NEAR(of_turned[static_cast<std::size_t>((o * taps + t) * shape.order + i)],
                                    expected[static_cast<std::size_t>((i * taps + t) * outputs + o)],
                                    this->kError);
        }
    }
}

TYPED_TEST(KernelTest, SigmoidAndTanhAreExactEnough) {
    using T = TypeParam;
    for (const Instructions instructions :
         {Instructions::portable, Instructions::avx2, Instructions::avx512}) {
        if (!supported(instructions)) continue;
        std::vector<T> x;
        for (int i = -800; i < 800; ++i) x.push_back(static_cast<T>(i) / T(8));
        std::vector<T> s = x, t = x;
        kernels<T>(instructions).sigmoid(s.data(), s.size());
        kernels<T>(instructions).tanh(t.data(), t.size());
        const double error = sizeof(T) == 4 ? 3e-7 : 1e-15;
        for (std::size_t i = 0; i < x.size(); ++i) {
            EXPECT_NEAR(static_cast<double>(s[i]), 1 / (1 + std::exp(-static_cast<double>(x[i]))), error);
            EXPECT_NEAR(static_cast<double>(t[i]), std::tanh(static_cast<double>(x[i])), error);
        }
    }
}

TEST(Kernels, AreAlwaysThereInPlainForm) {
    EXPECT_TRUE(supported(Instructions::portable));
    EXPECT_STREQ(kernels<float>(Instructions::portable).name, "portable");
}

TEST(Kernels, ThatTheProcessorLacksAreRefused) {
    for (const Instructions instructions : {Instructions::avx2, Instructions::avx512})
        if (!supported(instructions)) {
            EXPECT_THROW(kernels<float>(instructions), std::invalid_argument);
        }
}

}  // namespace
}  // namespace praxis::learned
