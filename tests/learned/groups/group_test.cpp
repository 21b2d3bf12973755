#include "learned/groups/group.hpp"

#include <gtest/gtest.h>

#include <set>

#include "learned/groups/shared_filter.hpp"
#include "learned/layers/convolution.hpp"
#include "tests/learned/support/fields.hpp"

namespace praxis::learned {
namespace {

class Groups : public testing::TestWithParam<const char*> {
  protected:
    const Group group{GetParam()};
    const std::vector<Representation> representations{trivial(group), regular(group), moves(group)};
};
INSTANTIATE_TEST_SUITE_P(All, Groups, testing::Values("c1", "c4", "d4"));

TEST_P(Groups, HaveInversesAndActAsTheirProducts) {
    for (int a = 0; a < group.order(); ++a) {
        EXPECT_EQ(group.product(a, group.inverse(a)), 0);
        for (int b = 0; b < group.order(); ++b) {
            const int ab = group.product(a, b);
            ASSERT_LT(ab, group.order());
            EXPECT_EQ(group.apply(ab, {3, 1}), group.apply(a, group.apply(b, {3, 1})));
            for (const Representation& r : representations)
                for (int k = 0; k < r.size; ++k) EXPECT_EQ(r(ab, k), r(a, r(b, k)));
        }
    }
}

TEST_P(Groups, RepresentationsPermute) {
    for (const Representation& r : representations)
        for (int g = 0; g < group.order(); ++g) {
            std::set<int> images;
            for (int k = 0; k < r.size; ++k) images.insert(r(g, k));
            EXPECT_EQ(images.size(), static_cast<std::size_t>(r.size));
            EXPECT_EQ(*images.rbegin(), r.size - 1);
        }
}

TEST_P(Groups, SharedFiltersCommuteWithTheGroup) {
    Random random(5);
    for (const Representation& in : representations)
        for (const Representation& out : representations)
            for (const int radius : {0, 1, 2})
                for (const Padding padding : {Padding::zero, Padding::circular}) {
                    const Fields inputs{in, 2}, outputs{out, 3};
                    ParameterLayout layout;
                    Convolution<double> layer(layout, "w", group, inputs, outputs, radius,
                                              Convolution<double>::Bias::yes);
                    std::vector<double> weights(layout.size());
                    for (double& weight : weights) weight = uniform(random, -1, 1);
                    layer.update(weights);
                    Planes<double> x(inputs.channels(), 7, 7, radius), y(outputs.channels(), 7, 7, 0),
                        gx = x, gy = y, of_gx = y;
                    randomise(x, random);
                    for (int g = 0; g < group.order(); ++g) {
                        turn(group, in, g, x, gx);
                        x.pad(padding);
                        gx.pad(padding);
                        layer.start(y);
                        layer.add(x, y);
                        layer.start(of_gx);
                        layer.add(gx, of_gx);
                        turn(group, out, g, y, gy);
                        EXPECT_LE(largest_difference(gy, of_gx), 1e-13);
                        EXPECT_GT(dot(y, y), 0.1);
                    }
                }
}

TEST(SharedFilter, HasTheKnownNumbersOfFreeWeights) {
    const Group d4("d4");
    const auto free = [&](const Representation& in, const Representation& out, int radius) {
        return SharedFilter(d4, {in, 1}, {out, 1}, radius).parameters();
    };
    EXPECT_EQ(free(trivial(d4), regular(d4), 1), 9u);
    EXPECT_EQ(free(trivial(d4), regular(d4), 2), 25u);
    EXPECT_EQ(free(regular(d4), regular(d4), 0), 8u);
    EXPECT_EQ(free(regular(d4), regular(d4), 1), 72u);
    EXPECT_EQ(free(regular(d4), regular(d4), 2), 200u);
    EXPECT_EQ(free(regular(d4), moves(d4), 0), 4u);
    EXPECT_EQ(free(trivial(d4), trivial(d4), 1), 3u);
    const Group c1("c1");
    EXPECT_EQ(SharedFilter(c1, {regular(c1), 10}, {moves(c1), 1}, 0).parameters(), 40u);
}

TEST(SharedFilter, APlainFilterDoesNotCommute) {
    const Group d4("d4"), c1("c1");
    Random random(6);
    ParameterLayout layout;
    Convolution<double> plain(layout, "w", c1, {trivial(c1), 8}, {trivial(c1), 4}, 0,
                              Convolution<double>::Bias::no);
    std::vector<double> weights(layout.size());
    for (double& weight : weights) weight = uniform(random, -1, 1);
    plain.update(weights);
    Planes<double> x(8, 5, 5, 0), y(4, 5, 5, 0), gx = x, gy = y, of_gx = y;
    randomise(x, random);
    turn(d4, regular(d4), 1, x, gx);
    plain.start(y);
    plain.add(x, y);
    plain.start(of_gx);
    plain.add(gx, of_gx);
    turn(d4, moves(d4), 1, y, gy);
    EXPECT_GT(largest_difference(gy, of_gx), 0.1);
}

TEST(SharedFilter, BoundedNormsHoldForEveryOutputAndLeaveSmallOnesAlone) {
    const Group d4("d4");
    const SharedFilter shared(d4, {regular(d4), 1}, {regular(d4), 3}, 1);
    Random random(7);
    std::vector<double> parameters(shared.parameters()), dense(shared.dense_size());
    for (double& weight : parameters) weight = uniform(random, -1, 1);
    for (std::size_t i = 0; i < parameters.size() / 3; ++i) parameters[i] *= 1e-3;  // the first field
    const std::vector<double> before = parameters;
    shared.bound_norm(std::span<double>(parameters), 0.9);
    shared.expand(std::span<const double>(parameters), std::span<double>(dense));
    for (int o = 0; o < shared.outputs(); ++o) {
        double norm = 0;
        for (std::size_t j = static_cast<std::size_t>(o); j < dense.size();
             j += static_cast<std::size_t>(shared.outputs()))
            norm += std::abs(dense[j]);
        if (o % 3 == 0)
            EXPECT_LT(norm, 0.5);
        else
            EXPECT_NEAR(norm, 0.9, 1e-6);
    }
    EXPECT_EQ(parameters[0], before[0]);
    const std::vector<double> once = parameters;
    shared.bound_norm(std::span<double>(parameters), 0.9);
    EXPECT_EQ(parameters, once);
}

TEST(Group, UnknownNamesAreRefused) {
    EXPECT_THROW(Group("d8"), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::learned
