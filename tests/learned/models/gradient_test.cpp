#include <gtest/gtest.h>

#include <cmath>

#include "learned/layers/uniform.hpp"
#include "tests/learned/models/support.hpp"

namespace praxis::learned {
namespace {

struct Network {
    std::string model, group;
    Padding padding;
    int radius;
};

std::vector<Network> networks() {
    std::vector<Network> result;
    for (const auto& [model, group] :
         std::initializer_list<std::pair<const char*, const char*>>{{"vin", "c1"},
                                                                    {"vin", "c4"},
                                                                    {"vin", "d4"},
                                                                    {"gru", "c1"},
                                                                    {"gru", "d4"},
                                                                    {"lstm", "c1"},
                                                                    {"lstm", "d4"}})
        for (const Padding padding : {Padding::zero, Padding::circular})
            for (const int radius : {1, 2}) result.push_back({model, group, padding, radius});
    return result;
}

class Gradient : public testing::TestWithParam<Network> {};
INSTANTIATE_TEST_SUITE_P(All, Gradient, testing::ValuesIn(networks()), [](const auto& instance) {
    return instance.param.model + "_" + instance.param.group +
           (instance.param.padding == Padding::zero ? "_zero" : "_circular") +
           std::to_string(instance.param.radius);
});

/// Difference quotients at weights that lie well inside of their bounds.
TEST_P(Gradient, AgreesWithDifferenceQuotients) {
    PlannerOptions options = small(GetParam().model, GetParam().group);
    options.padding = GetParam().padding;
    options.radius = options.input_radius = GetParam().radius;
    options.contraction = 0;
    const auto planner = make_planner<double>(options, 3);
    Random random(4);
    MapProblem problem = navigation_problem(7, random);
    problem.padding = options.padding;
    solve_exactly(problem);
    std::vector<double> gradient;
    loss_of(*planner, problem, &gradient);
    double size = 0;
    for (std::size_t i = 0; i < gradient.size(); i += 1 + gradient.size() / 60) {
        constexpr double kStep = 1e-6;
        double& weight = planner->parameters()[i];
        const double value = weight;
        weight = value + kStep;
        planner->update();
        const double above = loss_of(*planner, problem);
        weight = value - kStep;
        planner->update();
        const double below = loss_of(*planner, problem);
        weight = value;
        EXPECT_NEAR(gradient[i], (above - below) / (2 * kStep), 1e-7 * (1 + std::abs(gradient[i]))) << i;
        size += std::abs(gradient[i]);
    }
    EXPECT_GT(size, 1e-3);
}

}  // namespace
}  // namespace praxis::learned
