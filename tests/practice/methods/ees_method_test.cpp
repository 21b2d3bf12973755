#include "practice/methods/ees_method.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "practice/environments/light_switch.hpp"
#include "tests/practice/methods/method_driver.hpp"

namespace praxis::practice {
namespace {

using test::by_hand;
using test::MethodDriver;
using test::quick;
using test::RecordingWorld;

TEST(EesMethod, PrefersTheSkillThatTasksNeedToAnEquallyBadOne) {
    for (const char* name : {"ees", "ees-published"}) {
        for (const int needed : {0, 1}) {
            MethodDriver driver(2, 2, {{0, 1}}, {{1, {needed}}}, by_hand(name));
            for (const char* skill : {"(mark t0 p1)", "(mark t1 p1)"}) driver.tell(skill, 1, 4);
            const PracticeChoice choice = driver.first_choice();
            EXPECT_EQ(choice.chosen, "(mark t" + std::to_string(needed) + " p1)") << name;
            ASSERT_EQ(choice.candidates.size(), 2u);
            EXPECT_EQ(choice.candidates[0].predicted, choice.candidates[1].predicted);
            EXPECT_LT(choice.candidates[0].cost, choice.candidates[1].cost);
            EXPECT_EQ(std::isinf(choice.candidates[1].score), std::string(name) == "ees");
        }
    }
}

TEST(EesMethod, WalksToWhereTheSkillCanBePractised) {
    MethodDriver driver(1, 4, {{0, 1}, {1, 2}, {2, 3}}, {{1, {0}}}, by_hand("ees"));
    driver.tell("(mark t0 p3)", 1, 4);
    driver.begin_task();
    driver.method().begin_practice();
    std::vector<std::string> names;
    for (int i = 0; i < 4; ++i) {
        const auto decision = driver.method().practise(driver.now());
        ASSERT_TRUE(decision);
        names.push_back(driver.learner().skills().name(decision->skill));
        driver.execute(*decision);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"(move t0 p0 p1)", "(move t0 p1 p2)", "(move t0 p2 p3)",
                                               "(mark t0 p3)"}));
}

TEST(EesMethod, GivesUpASkillThatNeverSucceedsWhereThereIsAnotherWay) {
    const LightSwitch environment(6);
    for (const char* model : {"beta", "optimistic", "latent"}) {
        PracticeOptions options = quick("ees");
        options.cycle_steps = 60;
        options.competence.model = model;
        RecordingWorld world(environment, options.seed);
        PracticeLoop loop(environment, world, options);
        for (int cycle = 0; cycle < 10; ++cycle) loop.run_cycle();
        const auto is_jump = [&](const JournalStep& step) {
            return environment.description().schemas[static_cast<std::size_t>(step.skill.schema)].name ==
                   "jump-to-light";
        };
        const auto late = std::count_if(world.steps.end() - 300, world.steps.end(), is_jump);
        EXPECT_GT(std::ranges::count_if(world.steps, is_jump), 0) << model;
        EXPECT_EQ(late, 0) << model;
    }
}

}  // namespace
}  // namespace praxis::practice
