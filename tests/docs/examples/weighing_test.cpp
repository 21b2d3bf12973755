// The simulator of the example `practise_looking`: it agrees with its PDDL, and readings are as right as it
// says.
#include "docs/examples/weighing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "practice/planning/skill_task.hpp"

namespace weighing {
namespace {

using praxis::practice::State, praxis::practice::SkillIndex, praxis::practice::uniform;
const std::string kRoot = PRAXIS_SOURCE_DIR;

std::string text_of(const std::string& path) {
    std::ifstream file(kRoot + path);
    EXPECT_TRUE(file) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

class WeighingTest : public testing::Test {
  protected:
    void execute(State& state, SkillIndex skill) {
        std::vector<double> parameters(skills_.schema(skill).parameters.size());
        rehearsal_.propose(state, skills_.skill(skill), random_, parameters);
        rehearsal_.execute(state, skills_.skill(skill), parameters, random_);
    }
    std::vector<std::int32_t> values(const State& state) const {
        std::vector<std::int32_t> result;
        skills_.read(state, result);
        return result;
    }

    const Rehearsal rehearsal_{text_of("/domains/practice/weighing/domain.pddl"),
                               text_of("/problems/practice/weighing/two-boxes.pddl")};
    const praxis::practice::SkillTask skills_{rehearsal_};
    praxis::Random random_{1};
};

TEST_F(WeighingTest, SuccessIsWhatPddlPromises) {
    State state = rehearsal_.sample_task(random_).initial;
    std::vector<int> successes(skills_.size());
    for (int step = 0; step < 20000; ++step) {
        const std::vector<std::int32_t> before = values(state);
        std::vector<SkillIndex> applicable;
        skills_.for_each_applicable(before, [&](SkillIndex skill) { applicable.push_back(skill); });
        ASSERT_FALSE(applicable.empty());
        const SkillIndex skill = applicable[random_.below(applicable.size())];
        execute(state, skill);
        const std::vector<std::int32_t> after = values(state);
        if (!skills_.succeeded(skill, before, after)) continue;
        ++successes[skill];
        std::vector<std::int32_t> promised = before;
        for (const praxis::GroundEffect& effect : skills_.task().effects[skill])
            promised[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
        EXPECT_EQ(after, promised) << skills_.name(skill);
    }
    for (SkillIndex skill = 0; skill < skills_.size(); ++skill)
        EXPECT_GT(successes[skill], 0) << skills_.name(skill);
}

TEST_F(WeighingTest, OutOfPlaceASkillDoesNothing) {
    State state = rehearsal_.sample_task(random_).initial;
    for (int step = 0; step < 2000; ++step) {
        const auto skill = static_cast<SkillIndex>(random_.below(skills_.size()));
        const State before = state;
        execute(state, skill);
        if (!skills_.applicable(skill, values(before))) {
            EXPECT_EQ(state, before) << skills_.name(skill);
        }
    }
}

/// The share of readings of the robot at work that are right, if it waits as `wait` says.
double right_share(const std::function<double(std::size_t, double, praxis::Random&)>& wait) {
    namespace belief = praxis::belief;
    const std::string name = "/belief/sort-weight-display/";
    const auto task =
        belief::ground_belief(praxis::load_contingent(kRoot + "/domains" + name + "domain.pddl",
                                                      kRoot + "/problems" + name + "two-boxes.pddl")
                                  .task)
            .task;
    const Look look{wait, {0.75, 0.75}};
    const auto find = [&](const std::string& action) {
        std::uint32_t number = 0;
        while (task->physical->operator_name(praxis::OperatorId(number)) != action) ++number;
        return number;
    };
    const std::uint32_t take = find("(take-from-table box2 desk)"), go = find("(go desk balance)"),
                        put = find("(put-on-scale box2 balance)"), read = find("(read-display box2 balance)");
    int right = 0, all = 0, slips = 0;
    praxis::Random random(2);
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        Robot robot(task, *belief::sample_world(*task, random), look, random.next());
        while (robot.execute(take, {}).status == belief::Execution::Status::failed) ++slips;
        for (const std::uint32_t action : {go, put, read})
            EXPECT_EQ(robot.execute(action, {}).status, belief::Execution::Status::done);
        const std::vector<belief::Answer> answers = robot.observe(read, {});
        EXPECT_EQ(answers.size(), 1U);
        EXPECT_EQ(answers.front().accuracy, 0.75);
        right += robot.right_readings();
        all += robot.readings();
    }
    EXPECT_EQ(all, 2000);
    EXPECT_NEAR(slips / 2000.0, 0.05 / 0.95, 0.02);
    return static_cast<double>(right) / all;
}

TEST(WeighingRobot, ReadsAsWellAsItWaits) {
    EXPECT_NEAR(right_share([](std::size_t, double height, praxis::Random&) { return 2 + 6 * height; }), 0.98,
                0.01);
    EXPECT_NEAR(
        right_share([](std::size_t, double, praxis::Random& random) { return uniform(random, 0, 10); }),
        0.5 + 0.48 * std::sqrt(2 * 3.14159265) / 10, 0.03);
    EXPECT_NEAR(right_share([](std::size_t, double, praxis::Random&) { return 100.0; }), 0.5, 0.03);
}

TEST(WeighingRobot, ReadingsAreLikelierRightTheNearerTheBestTime) {
    for (const double height : {0.0, 0.5, 1.0}) {
        const double best = 2 + 6 * height;
        EXPECT_DOUBLE_EQ(chance_of_right_reading(best, height), 0.98);
        for (double off = 0; off < 4; off += 0.5)
            EXPECT_GT(chance_of_right_reading(best + off, height),
                      chance_of_right_reading(best + off + 0.5, height));
    }
}

}  // namespace
}  // namespace weighing
