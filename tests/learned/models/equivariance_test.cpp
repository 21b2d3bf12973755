// Turning the map turns the policy: |f(g x) - g f(x)| at initial weights and after training, and where it
// must not hold.
#include <gtest/gtest.h>

#include "learned/training/trainer.hpp"
#include "tests/learned/models/support.hpp"
#include "tests/learned/support/fields.hpp"

namespace praxis::learned {
namespace {

MapProblem turned(const Group& group, int g, const MapProblem& problem) {
    MapProblem result = problem;
    for (int cell = 0; cell < problem.cells(); ++cell) {
        const Offset to = turned_cell(group, g, {cell / problem.width, cell % problem.width}, problem.height);
        result.free[static_cast<std::size_t>(to.row * problem.width + to.column)] =
            problem.free[static_cast<std::size_t>(cell)];
        if (cell == problem.goal) result.goal = to.row * problem.width + to.column;
    }
    solve_exactly(result);
    return result;
}

/// The largest |f(g x) - g f(x)| over the elements of a group, relative to the largest logit or 1.
template <class T>
double deviation(const Planner<T>& planner, const Group& group, const MapSet& maps) {
    double largest = 0;
    const auto plain = planner.trace(maps.height, maps.width), other = planner.trace(maps.height, maps.width);
    Planes<T> expected = plain->policy;
    for (const MapProblem& problem : maps.problems) {
        draw(problem, *plain);
        planner.plan(*plain);
        Planes<T> none = plain->policy;
        none.clear();
        const double scale = largest_difference(plain->policy, none);
        EXPECT_GT(scale, 0);
        const double unit = std::max(1.0, scale);
        for (int g = 0; g < group.order(); ++g) {
            draw(turned(group, g, problem), *other);
            planner.plan(*other);
            turn(group, moves(group), g, plain->policy, expected);
            largest = std::max(largest, largest_difference(expected, other->policy) / unit);
        }
    }
    return largest;
}

struct Kind {
    std::string model, group;
    Differentiation differentiation;
    Padding padding;
};

class Equivariance : public testing::TestWithParam<Kind> {
  protected:
    static PlannerOptions options() {
        PlannerOptions result = small(GetParam().model, GetParam().group);
        result.padding = GetParam().padding;
        result.differentiation = GetParam().differentiation;
        result.iterations = 8;
        return result;
    }
    const MapSet maps = navigation_set(9, 2, 11);
};

std::vector<Kind> kinds() {
    std::vector<Kind> result;
    for (const char* group : {"c4", "d4"})
        for (const Padding padding : {Padding::zero, Padding::circular}) {
            for (const char* model : {"vin", "gru", "lstm"})
                result.push_back({model, group, Differentiation::unrolled, padding});
            for (const char* model : {"vin", "gru"})
                result.push_back({model, group, Differentiation::implicit, padding});
        }
    return result;
}
INSTANTIATE_TEST_SUITE_P(All, Equivariance, testing::ValuesIn(kinds()), [](const auto& instance) {
    return instance.param.model + "_" + instance.param.group +
           (instance.param.padding == Padding::zero ? "_zero" : "_circular") +
           (instance.param.differentiation == Differentiation::unrolled ? "" : "_implicit");
});

TEST_P(Equivariance, HoldsAtInitialWeightsToRounding) {
    const Group group(GetParam().group);
    EXPECT_LE(deviation(*make_planner<double>(options(), 1), group, maps), 1e-12);
    EXPECT_LE(deviation(*make_planner<float>(options(), 1), group, maps), 1e-5);
}

TEST_P(Equivariance, HoldsAfterTraining) {
    const MapSet lessons = navigation_set(9, 16, 12);
    const auto planner = make_planner<float>(options(), 1);
    const std::vector<float> before(planner->parameters().begin(), planner->parameters().end());
    TrainingOptions training;
    training.epochs = 3;
    training.batch = 4;
    training.rate = 0.01;
    Trainer trainer(*planner, lessons, training);
    double first = 0, last = 0;
    trainer.run([&](const EpochReport& report) {
        (report.epoch == 1 ? first : last) = report.loss;
        EXPECT_EQ(report.refused_steps, 0);
        return true;
    });
    EXPECT_LT(last, first);
    const Group group(GetParam().group);
    EXPECT_LE(deviation(*planner, group, maps), 1e-5);
    const auto exact = make_planner<double>(options(), 1);
    std::ranges::copy(planner->parameters(), exact->parameters().begin());
    exact->update();
    EXPECT_LE(deviation(*exact, group, maps), 1e-12);
}

TEST(EquivarianceOfPlainNetworks, DoesNotHold) {
    const Group d4("d4");
    const MapSet maps = navigation_set(9, 2, 11);
    for (const char* model : {"vin", "gru", "lstm"})
        EXPECT_GT(deviation(*make_planner<double>(small(model, "c1"), 1), d4, maps), 1e-2) << model;
    // Rotations alone do not give reflections.
    EXPECT_GT(deviation(*make_planner<double>(small("vin", "c4"), 1), d4, maps), 1e-2);
}

}  // namespace
}  // namespace praxis::learned
