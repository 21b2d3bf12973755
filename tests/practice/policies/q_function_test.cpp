#include "practice/policies/q_function.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "practice/environment.hpp"

namespace praxis::practice {
namespace {

using Action = QFunction::Action;

constexpr std::size_t kStep = 0, kStay = 1;

/// A corridor of places 0..3; a step leads on, and reaching place 3 ends it with reward 1.
void walk(QFunction& q) {
    for (double place : {0.0, 1.0, 2.0}) {
        const bool ends = place == 2;
        const std::vector<Action> next = {{kStep, {}}, {kStay, {}}};
        q.add({{place}, {kStep, {}}, ends ? 1.0 : 0.0, {place + 1}, next, ends});
        q.add({{place}, {kStay, {}}, 0, {place}, next, false});
    }
}

TEST(QFunction, LearnsTheValuesOfACorridor) {
    QFunction q(1, 2, 0);
    walk(q);
    Random random(1);
    for (int i = 0; i < 10; ++i) q.learn(random);
    constexpr std::array kStepping = {0.64, 0.8, 1.0};
    for (std::size_t place = 0; place < kStepping.size(); ++place) {
        const State here{static_cast<double>(place)};
        EXPECT_NEAR(q.value(here, {kStep, {}}), kStepping[place], 0.05) << place;
        EXPECT_NEAR(q.value(here, {kStay, {}}), 0.8 * kStepping[place], 0.05) << place;
    }
}

TEST(QFunction, LearnsWhichParametersAreRewarded) {
    QFunction q(1, 1, 1);
    Random random(2);
    for (int i = 0; i < 400; ++i) {
        const double x = uniform(random, -1, 1);
        const double p = uniform(random, -1, 1);
        q.add({{x}, {0, {p}}, std::abs(x - p) < 0.4 ? 1.0 : 0.0, {x}, {}, true});
    }
    for (int i = 0; i < 10; ++i) q.learn(random);
    EXPECT_GT(q.value(State{0.5}, {0, {0.5}}), 0.7);
    EXPECT_LT(q.value(State{0.5}, {0, {-0.5}}), 0.3);
}

TEST(QFunction, ValuesAreThoseOfEachAction) {
    QFunction q(1, 2, 0);
    walk(q);
    Random random(3);
    EXPECT_EQ(q.value(State{1}, {kStep, {}}), 0);
    q.learn(random);
    std::vector<double> values(2);
    q.values(State{1}, std::vector<Action>{{kStep, {}}, {kStay, {}}}, values);
    EXPECT_NEAR(values[0], q.value(State{1}, {kStep, {}}), 1e-6);
    EXPECT_NEAR(values[1], q.value(State{1}, {kStay, {}}), 1e-6);
    EXPECT_NE(values[0], values[1]);
}

TEST(QFunction, ReplayForgetsTheOldest) {
    QFunction q(1, 1, 0, {.replay = 3});
    for (int i = 0; i < 5; ++i) q.add({{1}, {0, {}}, i < 2 ? 100.0 : 1.0, {1}, {}, true});
    EXPECT_EQ(q.transitions(), 3u);
    Random random(4);
    for (int i = 0; i < 10; ++i) q.learn(random);
    EXPECT_NEAR(q.value(State{1}, {0, {}}), 1, 0.05);
}

TEST(QFunction, SameSeedSameValues) {
    std::array<double, 2> values{};
    for (double& value : values) {
        QFunction q(1, 2, 0);
        walk(q);
        Random random(5);
        q.learn(random);
        value = q.value(State{0}, {kStep, {}});
    }
    EXPECT_EQ(values[0], values[1]);
}

TEST(QFunction, RefusesWrongUse) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QFunction q(1, 2, 1);
    EXPECT_THROW(q.add({{1, 2}, {0, {}}, 0, {1}, {}, true}), std::invalid_argument);
    EXPECT_THROW(q.add({{1}, {2, {}}, 0, {1}, {}, true}), std::invalid_argument);
    EXPECT_THROW(q.add({{1}, {0, {1, 2}}, 0, {1}, {}, true}), std::invalid_argument);
    EXPECT_THROW(q.add({{nan}, {0, {}}, 0, {1}, {}, true}), std::invalid_argument);
    EXPECT_THROW(q.add({{1}, {0, {}}, nan, {1}, {}, true}), std::invalid_argument);
    EXPECT_THROW(q.add({{1}, {0, {}}, 0, {1, 2}, {}, false}), std::invalid_argument);
    EXPECT_THROW(q.add({{1}, {0, {}}, 0, {1}, {{0, {nan}}}, false}), std::invalid_argument);
    EXPECT_EQ(q.transitions(), 0u);
    EXPECT_THROW(QFunction(1, 0, 1), std::invalid_argument);
    EXPECT_THROW(QFunction(1, 1, 1, {.discount = 1}), std::invalid_argument);
    EXPECT_THROW(QFunction(1, 1, 1, {.replay = 0}), std::invalid_argument);
    EXPECT_THROW(QFunction(1, 1, 1, {.batch = 0}), std::invalid_argument);
    EXPECT_THROW(QFunction(1, 1, 1, {.learning_rate = nan}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::practice
