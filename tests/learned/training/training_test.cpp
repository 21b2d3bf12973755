#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "learned/maps/navigation.hpp"
#include "learned/training/checkpoint.hpp"
#include "learned/training/trainer.hpp"
#include "learned/weights/weights_file.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {
namespace {

TEST(Score, CountsArrivalsAndTheirLengths) {
    // A corridor of five cells, the goal at its east end, and a second row to go round.
    MapProblem problem;
    problem.height = 2;
    problem.width = 5;
    problem.free.assign(10, 1);
    problem.goal = 4;
    solve_exactly(problem);
    constexpr std::uint8_t N = 0, W = 1, S = 2, E = 3;
    const Score perfect = score(problem, std::vector<std::uint8_t>{E, E, E, E, E, N, N, N, N, N});
    EXPECT_EQ(perfect.success, 1);
    EXPECT_EQ(perfect.optimal, 1);
    EXPECT_EQ(perfect.spl, 1);
    // The first two cells go to and fro, and one leaves the map; all others arrive.
    const Score middling = score(problem, std::vector<std::uint8_t>{E, W, E, E, E, S, E, E, E, N});
    EXPECT_NEAR(middling.success, 6.0 / 9, 1e-12);
    EXPECT_NEAR(middling.optimal, 6.0 / 9, 1e-12);
    // The second cell goes back to the first, and that one goes by the lower row.
    const Score detour = score(problem, std::vector<std::uint8_t>{S, W, E, E, E, E, E, E, E, N});
    EXPECT_EQ(detour.success, 1);
    EXPECT_NEAR(detour.optimal, 7.0 / 9, 1e-12);
    EXPECT_NEAR(detour.spl, (7 + 4.0 / 6 + 3.0 / 7) / 9, 1e-12);
}

TEST(Score, OfAMapWithoutStartsIsOne) {
    MapProblem problem;
    problem.height = problem.width = 1;
    problem.free = {1};
    solve_exactly(problem);
    EXPECT_EQ(score(problem, std::vector<std::uint8_t>{0}).success, 1);
}

TEST(Optimizer, ClipsTheNorm) {
    std::vector<double> gradient{3, 4};
    EXPECT_DOUBLE_EQ(clip_norm(std::span<double>(gradient), 10), 5);
    EXPECT_EQ(gradient, (std::vector<double>{3, 4}));
    EXPECT_DOUBLE_EQ(clip_norm(std::span<double>(gradient), 1), 5);
    EXPECT_NEAR(gradient[0], 0.6, 1e-15);
    EXPECT_NEAR(gradient[1], 0.8, 1e-15);
}

TEST(Optimizer, FirstStepsAreAsPublished) {
    std::vector<double> x{1}, gradient{0.5};
    Optimizer<double> adam({Method::adam, 0, 0.99, 1e-8}, 1);
    adam.step(x, gradient, 0.1);
    EXPECT_NEAR(x[0], 0.9, 1e-7);  // Adam's first step is the rate
    std::vector<double> y{1};
    Optimizer<double> rmsprop({Method::rmsprop, 0, 0.99, 0}, 1);
    rmsprop.step(y, gradient, 0.01);
    EXPECT_NEAR(y[0], 1 - 0.01 * 0.5 / std::sqrt(0.01 * 0.25), 1e-12);
}

TEST(Optimizer, BothReachAMinimum) {
    for (const Method method : {Method::adam, Method::rmsprop}) {
        std::vector<double> x{3, -2};
        Optimizer<double> optimizer({method, 0, 0.9, 1e-8}, 2);
        for (int k = 0; k < 2000; ++k) {
            std::vector<double> gradient{2 * (x[0] - 1), 20 * (x[1] - 2)};
            optimizer.step(x, gradient, 0.02 * (1 - k / 2000.0));
        }
        EXPECT_NEAR(x[0], 1, 1e-2);
        EXPECT_NEAR(x[1], 2, 1e-2);
    }
}

TEST(Optimizer, RefusesAGradientThatIsNotFinite) {
    std::vector<float> x{1, 2};
    Optimizer<float> optimizer({}, 2);
    std::vector<float> gradient{std::numeric_limits<float>::quiet_NaN(), 1};
    EXPECT_FALSE(optimizer.step(x, gradient, 0.1));
    EXPECT_EQ(x, (std::vector<float>{1, 2}));
    EXPECT_EQ(optimizer.steps(), 0u);
}

PlannerOptions planner_of(const std::string& model) {
    PlannerOptions options;
    options.model = model;
    options.fields = 4;
    options.iterations = 8;
    return options;
}

TrainingOptions short_run(int threads) {
    TrainingOptions options;
    options.epochs = 4;
    options.batch = 20;
    options.rate = 0.02;
    options.threads = threads;
    return options;
}

std::vector<float> weights_of(const Planner<float>& planner) {
    return {planner.parameters().begin(), planner.parameters().end()};
}

class Training : public testing::TestWithParam<const char*> {
  protected:
    const MapSet maps = navigation_set(9, 50, 1);
};
INSTANTIATE_TEST_SUITE_P(All, Training, testing::Values("vin", "gru", "lstm"));

TEST_P(Training, LowersTheLossAndDoesNotDependOnThreads) {
    std::vector<std::vector<float>> weights;
    for (const int threads : {1, 2, 3}) {
        const auto planner = make_planner<float>(planner_of(GetParam()), 1);
        Trainer trainer(*planner, maps, short_run(threads));
        std::vector<double> losses;
        trainer.run([&](const EpochReport& report) {
            losses.push_back(report.loss);
            return true;
        });
        ASSERT_EQ(losses.size(), 4u);
        EXPECT_LT(losses.back(), losses.front());
        weights.push_back(weights_of(*planner));
    }
    EXPECT_EQ(weights[0], weights[1]);
    EXPECT_EQ(weights[0], weights[2]);
}

TEST_P(Training, GoesOnFromACheckpointAsIfItHadNeverStopped) {
    const std::string file =
        (std::filesystem::temp_directory_path() / (std::string("praxis_checkpoint_") + GetParam())).string();
    const auto whole = make_planner<float>(planner_of(GetParam()), 1);
    Trainer(*whole, maps, short_run(1)).run([](const EpochReport&) { return true; });

    const auto first = make_planner<float>(planner_of(GetParam()), 1);
    Trainer stopped(*first, maps, short_run(1));
    stopped.run([](const EpochReport& report) { return report.epoch < 2; });
    EXPECT_EQ(stopped.epochs_done(), 2);
    write_checkpoint(file, stopped);

    const auto second = make_planner<float>(planner_of(GetParam()), 99);
    Trainer resumed(*second, maps, short_run(2));
    read_checkpoint(file, resumed);
    EXPECT_EQ(resumed.epochs_done(), 2);
    resumed.run([](const EpochReport&) { return true; });
    EXPECT_EQ(weights_of(*second), weights_of(*whole));
    EXPECT_EQ(weights_of(*read_planner(file).planner), weights_of(*first));

    TrainingOptions others = short_run(1);
    others.rate = 0.01;
    Trainer different(*second, maps, others);
    EXPECT_THROW(read_checkpoint(file, different), InputError);
    PlannerOptions deeper = planner_of(GetParam());
    deeper.iterations = 9;
    const auto other_planner = make_planner<float>(deeper, 1);
    Trainer other_trainer(*other_planner, maps, short_run(1));
    EXPECT_THROW(read_checkpoint(file, other_trainer), InputError);
    write_planner(file, *first, {});
    EXPECT_THROW(read_checkpoint(file, resumed), InputError);
    std::filesystem::remove(file);
}

TEST(Trainer, RefusesWhatCannotBeTrained) {
    const auto planner = make_planner<float>(planner_of("vin"), 1);
    EXPECT_THROW(Trainer(*planner, MapSet{}, {}), std::invalid_argument);
    TrainingOptions options;
    options.batch = 0;
    EXPECT_THROW(Trainer(*planner, navigation_set(9, 1, 1), options), std::invalid_argument);
}

TEST(Evaluation, AgreesOverThreads) {
    const auto planner = make_planner<float>(planner_of("vin"), 1);
    const MapSet maps = navigation_set(9, 20, 1);
    const Score one = evaluate(*planner, maps, 1), three = evaluate(*planner, maps, 3);
    EXPECT_EQ(one.success, three.success);
    EXPECT_EQ(one.spl, three.spl);
    EXPECT_LE(one.optimal, one.success);
    EXPECT_LE(one.optimal, one.spl + 1e-12);
    EXPECT_LE(one.spl, one.success + 1e-12);
}

// Without a bound, deep symmetric value iteration overflows within a few steps at high rates; with it, it
// cannot.
TEST(BoundedNorms, KeepDeepNetworksFinite) {
    PlannerOptions options = planner_of("vin");
    options.group = "d4";
    options.iterations = 300;
    const MapSet maps = navigation_set(9, 4, 1);
    TrainingOptions training = short_run(1);
    training.epochs = 5;
    training.batch = 2;
    training.rate = 1;
    const auto refused = [&](double contraction) {
        options.contraction = contraction;
        const auto planner = make_planner<float>(options, 1);
        int steps = 0;
        Trainer(*planner, maps, training).run([&](const EpochReport& report) {
            steps += report.refused_steps + !std::isfinite(report.loss);
            return true;
        });
        return steps;
    };
    EXPECT_EQ(refused(1), 0);
    EXPECT_GT(refused(0), 0);
}

}  // namespace
}  // namespace praxis::learned
