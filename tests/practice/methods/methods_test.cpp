#include <gtest/gtest.h>

#include <stdexcept>

#include "practice/environments/environments.hpp"
#include "tests/practice/methods/method_driver.hpp"

namespace praxis::practice {
namespace {

using test::MethodDriver;
using test::quick;
using test::Tokens;

TEST(Methods, RunOnEveryEnvironment) {
    for (const char* name : {"light-switch(cells=5)", "ball-ring", "playroom", "kitchen"}) {
        const auto environment = make_environment(name);
        for (const MethodInfo& method : methods()) {
            PracticeOptions options = quick(method.name);
            options.cycles = 1;
            options.test_tasks = 0;
            const RunResult result = run_practice(*environment, options);
            ASSERT_EQ(result.curve.size(), 2u) << name << " " << method.name;
            EXPECT_EQ(result.curve[1].transitions, 20) << name << " " << method.name;
            EXPECT_EQ(result.method, method.name);
        }
    }
}

TEST(Methods, AreListedWithTheFirstOneTheDefault) {
    ASSERT_FALSE(methods().empty());
    EXPECT_EQ(methods().front().name, PracticeOptions().method);
    for (const MethodInfo& method : methods()) EXPECT_FALSE(method.description.empty()) << method.name;
}

TEST(Methods, UnknownNamesAreAnsweredWithThoseThereAre) {
    const Tokens environment(1, 2, {{0, 1}});
    Learner learner(environment, quick());
    try {
        make_method("eees", learner);
        FAIL();
    } catch (const std::invalid_argument& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("'eees'"), std::string::npos);
        for (const MethodInfo& method : methods())
            EXPECT_NE(text.find(method.name), std::string::npos) << text;
    }
}

TEST(Methods, RandomSkillsAreThoseThatCanBeExecuted) {
    MethodDriver driver(1, 4, {{0, 1}, {0, 2}, {1, 3}}, {{1, {0}}}, quick("random-skills"));
    driver.begin_task();
    driver.method().begin_practice();
    std::vector<int> met(driver.learner().skills().size());
    for (int i = 0; i < 100; ++i) {
        const auto decision = driver.method().practise(driver.now());
        ASSERT_TRUE(decision);
        EXPECT_FALSE(decision->greedy);
        ++met[decision->skill];
    }
    const SkillTask& skills = driver.learner().skills();
    EXPECT_GT(met[skills.find("(move t0 p0 p1)")], 25);
    EXPECT_GT(met[skills.find("(move t0 p0 p2)")], 25);
    EXPECT_EQ(met[skills.find("(move t0 p1 p3)")] + met[skills.find("(mark t0 p3)")], 0);
}

TEST(Methods, TaskRepeatGoesThereAndBack) {
    MethodDriver driver(1, 3, {{0, 1}, {1, 0}, {1, 2}, {2, 1}}, {{0, {0, 3}}}, quick("task-repeat"));
    driver.begin_task();
    driver.method().begin_practice();
    std::vector<double> places;
    for (int i = 0; i < 8; ++i) {
        const auto decision = driver.method().practise(driver.now());
        ASSERT_TRUE(decision);
        driver.execute(*decision);
        places.push_back(driver.state[0]);
    }
    EXPECT_EQ(places, (std::vector<double>{1, 2, 1, 0, 1, 2, 1, 0}));
}

TEST(Methods, TaskRepeatTakesRandomSkillsWhereThereIsNoWayBack) {
    MethodDriver driver(1, 4, {{0, 1}, {1, 2}, {2, 1}, {1, 3}}, {{0, {0, 4}}}, quick("task-repeat"));
    driver.begin_task();
    driver.state[0] = 1;
    driver.method().begin_practice();
    auto decision = driver.method().practise(driver.now());  // there is no way back, but one there
    ASSERT_TRUE(decision);
    driver.execute(*decision);
    EXPECT_EQ(driver.state[0], 3);
    decision = driver.method().practise(driver.now());
    ASSERT_TRUE(decision);
    EXPECT_EQ(driver.learner().skills().name(decision->skill), "(mark t0 p3)");
}

}  // namespace
}  // namespace praxis::practice
