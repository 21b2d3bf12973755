// Implicit differentiation against what it stands for: backpropagation through very many iterations.
#include <gtest/gtest.h>

#include <cmath>

#include "learned/layers/fixed_point.hpp"
#include "learned/layers/uniform.hpp"
#include "tests/learned/models/support.hpp"

namespace praxis::learned {
namespace {

struct Kind {
    std::string model, group;
    int anderson;
    Padding padding;
};

class Implicit : public testing::TestWithParam<Kind> {};
INSTANTIATE_TEST_SUITE_P(
    All, Implicit,
    testing::Values(Kind{"vin", "c1", 5, Padding::zero}, Kind{"vin", "d4", 5, Padding::zero},
                    Kind{"vin", "c1", 0, Padding::circular}, Kind{"vin", "d4", 0, Padding::zero},
                    Kind{"gru", "c1", 5, Padding::zero}, Kind{"gru", "d4", 5, Padding::circular},
                    Kind{"gru", "c4", 0, Padding::circular}),
    [](const auto& instance) {
        return instance.param.model + "_" + instance.param.group + "_" +
               std::to_string(instance.param.anderson) +
               (instance.param.padding == Padding::zero ? "_zero" : "_circular");
    });

TEST_P(Implicit, GradientAgreesWithBackpropagation) {
    PlannerOptions options = small(GetParam().model, GetParam().group);
    options.padding = GetParam().padding;
    options.contraction = 0.9;
    options.iterations = 300;
    options.tolerance = 1e-13;
    options.anderson = GetParam().anderson;
    options.backward_iterations = 200;
    const auto unrolled = make_planner<double>(options, 5);
    options.differentiation = Differentiation::implicit;
    const auto implicit = make_planner<double>(options, 5);
    Random random(6);
    const MapProblem problem = navigation_problem(9, random);
    std::vector<double> expected, found;
    EXPECT_NEAR(loss_of(*unrolled, problem, &expected), loss_of(*implicit, problem, &found), 1e-10);
    double difference = 0, size = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        difference += std::pow(found[i] - expected[i], 2);
        size += std::pow(expected[i], 2);
    }
    EXPECT_GT(size, 1e-6);
    EXPECT_LE(std::sqrt(difference / size), 1e-6);
}

TEST_P(Implicit, StopsAtTheFixedPointAndSaysHowCloseItIs) {
    PlannerOptions options = small(GetParam().model, GetParam().group);
    options.padding = GetParam().padding;
    options.contraction = 0.9;
    options.iterations = 300;
    options.differentiation = Differentiation::implicit;
    const auto planner = make_planner<double>(options, 5);
    Random random(6);
    const MapProblem problem = navigation_problem(9, random);
    const auto trace = planner->trace(9, 9);
    draw(problem, *trace);
    planner->plan(*trace);
    EXPECT_LT(trace->iterations, 300);
    EXPECT_LE(trace->residual, options.tolerance);
    planner->set_iterations(2);
    planner->plan(*trace);
    EXPECT_EQ(trace->iterations, 2);
    EXPECT_GT(trace->residual, options.tolerance);
}

TEST(AdjointSolver, SolvesAndAndersonNeedsFewerSteps) {
    // u = A u + b with A = 0.95 * a cyclic shift.
    constexpr std::size_t kSize = 40;
    const auto solve = [&](int mixed, std::vector<double>& u) {
        Random random(1);
        std::vector<double> b(kSize);
        for (double& value : b) value = uniform(random, -1, 1);
        u = b;
        AdjointSolver<double> solver(mixed, 1000, 1e-10);
        const auto apply = [&](std::span<const double> x, std::span<double> image) {
            for (std::size_t i = 0; i < kSize; ++i) image[i] = 0.8 * x[i] + 0.15 * x[(i + 1) % kSize] + b[i];
        };
        const AdjointResult result = solver.solve(u, apply);
        std::vector<double> image(kSize);
        apply(u, image);
        for (std::size_t i = 0; i < kSize; ++i) EXPECT_NEAR(image[i], u[i], 1e-8);
        EXPECT_LE(result.residual, 1e-10);
        return result.iterations;
    };
    std::vector<double> plain, mixed;
    EXPECT_LT(solve(5, mixed), solve(0, plain) / 2);
}

TEST(AdjointSolver, ReturnsAtOnceWithoutAGradient) {
    std::vector<double> u(5);
    AdjointSolver<double> solver(5, 100, 1e-6);
    EXPECT_EQ(solver.solve(u, [](std::span<const double>, std::span<double>) { FAIL(); }).iterations, 0);
}

TEST(MakePlanner, RefusesOptionsOutOfRange) {
    const auto refused = [](auto change) {
        PlannerOptions options;
        change(options);
        EXPECT_THROW(make_planner<float>(options, 1), std::invalid_argument);
    };
    refused([](PlannerOptions& o) { o.model = "transformer"; });
    refused([](PlannerOptions& o) { o.group = "d8"; });
    refused([](PlannerOptions& o) { o.fields = 0; });
    refused([](PlannerOptions& o) { o.fields = 256; });
    refused([](PlannerOptions& o) { o.iterations = 0; });
    refused([](PlannerOptions& o) { o.radius = 3; });
    refused([](PlannerOptions& o) { o.input_radius = 0; });
    refused([](PlannerOptions& o) { o.contraction = 1.5; });
    refused([](PlannerOptions& o) { o.contraction = std::nan(""); });
    refused([](PlannerOptions& o) { o.tolerance = 0; });
    refused([](PlannerOptions& o) { o.anderson = 99; });
    refused([](PlannerOptions& o) {
        o.model = "lstm";
        o.differentiation = Differentiation::implicit;
    });
}

}  // namespace
}  // namespace praxis::learned
