#include "practice/methods/plan_follower.hpp"

#include <gtest/gtest.h>

#include "tests/practice/methods/method_driver.hpp"

namespace praxis::practice {
namespace {

using test::by_hand;
using test::MethodDriver;

/// Two ways from p0 to p3, and p4 that leads nowhere.
struct TwoWays : ::testing::Test {
    MethodDriver driver{
        1, 5, {{0, 1}, {1, 3}, {0, 2}, {2, 3}, {0, 4}}, {{0, {0, 4}}}, by_hand("task-repeat")};
    PlanFollower follower{driver.learner(), driver.learner().planner()};

    std::string next() { return next(driver.goal()); }
    std::string next(const std::vector<Fact>& goal) {
        const auto skill = follower.next(driver.now().values, goal);
        return skill ? driver.learner().skills().name(*skill) : "";
    }
    std::vector<Fact> at(int place) {
        return driver.learner().skills().goal(std::vector<GroundAtom>{{0, {0, 1 + place}}});
    }
};

TEST_F(TwoWays, FollowsThePlanToItsEnd) {
    driver.tell("(move t0 p0 p1)", 0, 3);
    EXPECT_EQ(next(), "(move t0 p0 p2)");
    EXPECT_FALSE(follower.replanned());
    follower.observe(true);
    driver.state[0] = 2;
    EXPECT_EQ(next(), "(move t0 p2 p3)");
    EXPECT_FALSE(follower.replanned());
    follower.observe(true);
    driver.state[0] = 3;
    EXPECT_EQ(next(), "");
}

TEST_F(TwoWays, KeepsToThePlanUntilSomethingFails) {
    driver.tell("(move t0 p0 p1)", 0, 1);
    EXPECT_EQ(next(), "(move t0 p0 p2)");
    driver.tell("(move t0 p2 p3)", 0, 9);
    follower.observe(true);
    driver.state[0] = 2;
    EXPECT_EQ(next(), "(move t0 p2 p3)");
    follower.observe(false);
    driver.state[0] = 0;
    EXPECT_EQ(next(), "(move t0 p0 p1)");
    EXPECT_TRUE(follower.replanned());
}

TEST_F(TwoWays, PlansAnewWhereASkillFailed) {
    driver.tell("(move t0 p0 p1)", 0, 1);
    EXPECT_EQ(next(), "(move t0 p0 p2)");
    driver.tell("(move t0 p0 p2)", 0, 5);
    follower.observe(false);
    EXPECT_EQ(next(), "(move t0 p0 p1)");
    EXPECT_TRUE(follower.replanned());
}

TEST_F(TwoWays, PlansAnewWhereTheWorldIsNotAsPlanned) {
    driver.tell("(move t0 p0 p1)", 0, 1);
    EXPECT_EQ(next(), "(move t0 p0 p2)");
    follower.observe(true);
    driver.state[0] = 1;
    EXPECT_EQ(next(), "(move t0 p1 p3)");
    EXPECT_TRUE(follower.replanned());
    follower.observe(true);
    driver.state[0] = 2;  // the plan is at its end, the goal does not hold
    EXPECT_EQ(next(), "(move t0 p2 p3)");
    EXPECT_TRUE(follower.replanned());
}

TEST_F(TwoWays, AnotherGoalIsAPlanAnewButNoFailure) {
    driver.tell("(move t0 p0 p1)", 0, 1);
    EXPECT_EQ(next(), "(move t0 p0 p2)");
    follower.observe(true);
    EXPECT_EQ(next(at(4)), "(move t0 p0 p4)");
    EXPECT_FALSE(follower.replanned());
}

TEST_F(TwoWays, ForgettingIsNoFailure) {
    EXPECT_NE(next(), "");
    follower.observe(false);
    follower.forget();
    EXPECT_NE(next(), "");
    EXPECT_FALSE(follower.replanned());
}

TEST_F(TwoWays, SaysThatThereIsNoPlan) {
    driver.state[0] = 4;
    EXPECT_EQ(next(), "");
    EXPECT_EQ(next(), "");
    driver.state[0] = 1;
    EXPECT_EQ(next(), "(move t0 p1 p3)");
}

}  // namespace
}  // namespace praxis::practice
