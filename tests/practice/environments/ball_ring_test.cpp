#include <cmath>

#include "practice/environments/ball_ring.hpp"
#include "tests/practice/environments/abstract_task.hpp"

namespace praxis::practice::test {
namespace {

class BallRingTest : public testing::TestWithParam<BallRing::Features> {
  protected:
    const BallRing environment_{GetParam()};
    const AbstractTask task_{environment_};
    const std::size_t place_ring_ = task_.find("place-ring-on-table smooth-table");

    void execute(State& state, const std::string& name, const std::vector<double>& parameters = {}) {
        environment_.execute(state, task_.skills()[task_.find(name)], parameters, random_);
    }
    /// With the ring in the hand, beside a table.
    State holding_ring(const std::string& table) {
        State state = environment_.sample_task(random_).initial;
        execute(state, "navigate-to-ring");
        execute(state, "pick-ring-from-floor");
        execute(state, "navigate-to-table " + table);
        return state;
    }
    bool holds(const State& state, const std::string& predicate,
               std::vector<std::int32_t> objects = {}) const {
        const std::vector<std::string>& names = environment_.description().predicates;
        const auto found = std::find(names.begin(), names.end(), predicate);
        return environment_.holds(state,
                                  {static_cast<std::int32_t>(found - names.begin()), std::move(objects)});
    }
    /// The parameters that put the ring into the centre of the smooth table.
    std::vector<double> centre(const State& state) const {
        std::vector<double> features(environment_.description().schemas[13].features.size());
        environment_.features(state, task_.skills()[place_ring_], features);
        if (GetParam() == BallRing::Features::raw) return {features[10], features[11]};
        return {-state[10], -state[11]};
    }
    template <class Parameters>
    double rate_of_staying(const std::string& table, std::int32_t number, Parameters parameters) {
        constexpr int kTries = 20000;
        const std::size_t skill = task_.find("place-ring-on-table " + table);
        int stays = 0;
        for (int i = 0; i < kTries; ++i) {
            State state = holding_ring(table);
            environment_.execute(state, task_.skills()[skill], parameters(state, skill), random_);
            stays += holds(state, "ring-on", {number}) ? 1 : 0;
            EXPECT_NE(holds(state, "ring-on", {number}), holds(state, "ring-on-floor"));
        }
        return static_cast<double>(stays) / kTries;
    }
    std::vector<double> proposal(const State& state, std::size_t skill) {
        std::vector<double> parameters(2);
        environment_.propose(state, task_.skills()[skill], random_, parameters);
        return parameters;
    }

    Random random_{1};
};

TEST_P(BallRingTest, SixteenSkillsAndOnePlanOfEight) {
    EXPECT_EQ(environment_.description().schemas.size(), 16U);
    EXPECT_EQ(environment_.description().horizon, 8);
    EXPECT_EQ(environment_.description().cycle_steps, 250);
    for (int i = 0; i < 10; ++i) {
        const PracticeTask drawn = environment_.sample_task(random_);
        EXPECT_LE(task_.distance(drawn), 4);
        EXPECT_EQ(task_.distance(drawn, {"place-ball-on-table"}), 8);
    }
}

TEST_P(BallRingTest, ThePlanOfEightWorksWhereTheRingStays) {
    const PracticeTask drawn = environment_.sample_task(random_);
    State state = drawn.initial;
    execute(state, "navigate-to-ring");
    execute(state, "pick-ring-from-floor");
    execute(state, "navigate-to-table smooth-table");
    const std::vector<double> in_disc =
        GetParam() == BallRing::Features::relative ? std::vector<double>{0, 0} : [&] {
            std::vector<double> p = centre(state);
            p[0] += state[10];
            p[1] += state[11];
            return p;
        }();
    execute(state, "place-ring-on-table smooth-table", in_disc);
    EXPECT_TRUE(holds(state, "ring-on", {0}));
    execute(state, "navigate-to-table table-1");
    execute(state, "pick-ball-from-table table-1");
    execute(state, "navigate-to-ring");
    EXPECT_FALSE(task_.reached(state, drawn.goal));
    execute(state, "place-ball-in-ring-on-table smooth-table");
    EXPECT_TRUE(task_.reached(state, drawn.goal));
}

TEST_P(BallRingTest, TheRingStaysAsOftenAsPublished) {
    EXPECT_NEAR(
        rate_of_staying("smooth-table", 0, [&](const State& s, std::size_t k) { return proposal(s, k); }),
        0.43, 0.015);
    EXPECT_NEAR(rate_of_staying("smooth-table", 0, [&](const State& s, std::size_t) { return centre(s); }),
                0.35 / 0.65, 0.015);
    EXPECT_EQ(rate_of_staying("table-3", 3, [&](const State& s, std::size_t k) { return proposal(s, k); }),
              1);
}

TEST_P(BallRingTest, TheBallRollsOffEveryTable) {
    for (std::int32_t table = 0; table < 5; ++table) {
        const std::string name = environment_.description().objects[static_cast<std::size_t>(table)];
        State state = environment_.sample_task(random_).initial;
        execute(state, "navigate-to-table table-1");
        execute(state, "pick-ball-from-table table-1");
        execute(state, "navigate-to-table " + name);
        EXPECT_TRUE(holds(state, "holding-ball"));
        const std::size_t skill = task_.find("place-ball-on-table " + name);
        execute(state, "place-ball-on-table " + name, proposal(state, skill));
        EXPECT_FALSE(holds(state, "ball-on", {table}));
        EXPECT_TRUE(holds(state, "ball-on-floor"));
        EXPECT_TRUE(holds(state, "hand-empty"));
    }
}

TEST_P(BallRingTest, OffTheTableTheRingFalls) {
    for (const std::string table : {"smooth-table", "table-2"}) {
        State state = holding_ring(table);
        execute(state, "place-ring-on-table " + table, {100, -100});
        EXPECT_TRUE(holds(state, "ring-on-floor"));
    }
}

INSTANTIATE_TEST_SUITE_P(Features, BallRingTest,
                         testing::Values(BallRing::Features::raw, BallRing::Features::relative),
                         [](const auto& features) {
                             return features.param == BallRing::Features::raw ? "raw" : "relative";
                         });

}  // namespace
}  // namespace praxis::practice::test
