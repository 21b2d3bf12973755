// Kitchen and playroom: the success models as they are stated, and what practice can gain.
#include <algorithm>
#include <cmath>

#include "practice/environments/kitchen.hpp"
#include "practice/environments/playroom.hpp"
#include "tests/practice/environments/abstract_task.hpp"

namespace praxis::practice::test {
namespace {

template <class T>
struct Stated {
    T environment;
    AbstractTask task{environment};
    Random random{1};

    std::vector<double> proposal(const State& state, std::size_t skill) {
        std::vector<double> parameters(task.parameter_count(skill));
        environment.propose(state, task.skills()[skill], random, parameters);
        return parameters;
    }
    std::vector<double> optimum(const State& state, std::size_t skill) const {
        std::vector<double> parameters(task.parameter_count(skill));
        environment.optimum(state, task.skills()[skill], parameters);
        return parameters;
    }
    double unpractised_share(int count) {
        return task.solved_share(
            count, [&](const State& state, std::size_t skill) { return proposal(state, skill); }, random);
    }
    double perfect_share(int count) {
        return task.solved_share(
            count, [&](const State& state, std::size_t skill) { return optimum(state, skill); }, random);
    }
    /// The mean success probability of proposals for a skill, which depends on nothing else that tasks draw.
    double prior(const std::string& name) {
        const std::size_t skill = task.find(name);
        constexpr int kTries = 20000;
        double sum = 0;
        for (int i = 0; i < kTries; ++i) {
            const State state = environment.sample_task(random).initial;
            sum += environment.success_probability(state, task.skills()[skill], proposal(state, skill));
        }
        return sum / kTries;
    }
};

TEST(LogisticSuccess, IsHalfTheCeilingAtTheTolerance) {
    const LogisticSuccess model{.tolerance = 0.5, .width = 0.1, .ceiling = 0.8};
    EXPECT_DOUBLE_EQ(model.probability(0.5), 0.4);
    EXPECT_NEAR(model.probability(0.5 + 0.1 * std::log(3.0)), 0.2, 1e-12);
    EXPECT_NEAR(model.probability(0), 0.8 / (1 + std::exp(-5.0)), 1e-12);
    EXPECT_EQ(model.probability(1e300), 0);
}

TEST(Kitchen, SolvesFewTasksUnpractisedAndNearlyAllWhenPerfect) {
    Stated<Kitchen> kitchen;
    EXPECT_NEAR(kitchen.unpractised_share(800), 0.38, 0.05);
    EXPECT_GE(kitchen.perfect_share(200), 0.97);
}

TEST(Kitchen, ProposalsSucceedAsOftenAsStated) {
    Stated<Kitchen> kitchen;
    EXPECT_NEAR(kitchen.prior("pick cup table"), 0.37, 0.015);
    EXPECT_NEAR(kitchen.prior("place plate shelf"), 0.32, 0.015);
    EXPECT_NEAR(kitchen.prior("sweep bread-crumbs brush table"), 0.31, 0.015);
    EXPECT_NEAR(kitchen.prior("open-drawer counter"), 0.24, 0.015);
    EXPECT_EQ(kitchen.prior("place cup floor"), 1);
}

TEST(Kitchen, TheLampCannotBeLearned) {
    Stated<Kitchen> kitchen;
    const State state = kitchen.environment.sample_task(kitchen.random).initial;
    for (const char* name : {"switch-lamp-on", "switch-lamp-off"})
        for (const double x : {-1.0, 0.0, 7.0})
            EXPECT_DOUBLE_EQ(
                kitchen.environment.success_probability(state, kitchen.task.skills()[kitchen.task.find(name)],
                                                        std::vector<double>{x, -x}),
                0.3);
}

TEST(Kitchen, NoTaskNeedsTheDrawerOrTheLamp) {
    Stated<Kitchen> kitchen;
    for (int i = 0; i < 50; ++i) {
        const PracticeTask task = kitchen.environment.sample_task(kitchen.random);
        EXPECT_EQ(kitchen.task.distance(task),
                  kitchen.task.distance(
                      task, {"open-drawer", "close-drawer", "switch-lamp-on", "switch-lamp-off"}));
    }
}

TEST(Playroom, SolvesFewTasksUnpractisedAndNearlyAllWhenPerfect) {
    Stated<Playroom> playroom;
    EXPECT_NEAR(playroom.unpractised_share(300), 0.18, 0.07);
    EXPECT_GE(playroom.perfect_share(100), 0.97);
}

TEST(Playroom, ProposalsSucceedAsOftenAsStated) {
    Stated<Playroom> playroom;
    EXPECT_NEAR(playroom.prior("pick-toy car table"), 0.46, 0.015);
    EXPECT_NEAR(playroom.prior("open-closet closet"), 0.39, 0.015);
    EXPECT_NEAR(playroom.prior("pull-chair-away corner"), 0.35, 0.015);
    EXPECT_NEAR(playroom.prior("sweep car duck sweeper bin corner"), 0.07, 0.01);
    EXPECT_NEAR(playroom.prior("dump car duck bin corner"), 0.47, 0.015);
}

TEST(Playroom, SweepingTakesALongPlanInAModerateStateSpace) {
    Stated<Playroom> playroom;
    const PracticeTask first = playroom.environment.sample_task(playroom.random);
    EXPECT_EQ(playroom.task.reachable(first.initial, 50000), 2416U);
    std::int64_t shortest = 100;
    std::int64_t longest = 0;
    for (int i = 0; i < 200; ++i) {
        const auto distance = playroom.task.distance(playroom.environment.sample_task(playroom.random));
        ASSERT_TRUE(distance);
        shortest = std::min(shortest, *distance);
        longest = std::max(longest, *distance);
    }
    EXPECT_EQ(shortest, 9);
    EXPECT_EQ(longest, 18);
}

TEST(Playroom, AfterTheTaskSweepingAgainHasToBePrepared) {
    Stated<Playroom> playroom;
    const PracticeTask task = playroom.environment.sample_task(playroom.random);
    State state = task.initial;
    while (!playroom.task.reached(state, task.goal)) {
        const std::vector<std::size_t> steps =
            playroom.task.plan(playroom.task.values(state).value(), playroom.task.facts(task.goal));
        ASSERT_FALSE(steps.empty());
        playroom.environment.execute(state, playroom.task.skills()[steps[0]],
                                     playroom.optimum(state, steps[0]), playroom.random);
    }
    // Put the sweeper back, fetch the bin, dump, put the bin, fetch the sweeper again, and the ways between.
    const std::size_t sweep = playroom.task.find("sweep car duck sweeper bin corner");
    EXPECT_EQ(playroom.task.steps_before(state, sweep), 9);
}

}  // namespace
}  // namespace praxis::practice::test
