#include "tamp/skills/refined_skill.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/tamp/samples/sample_document.hpp"
#include "tests/tamp/support/gantry.hpp"

namespace praxis::tamp {
namespace {

using test::at;
using test::cups;
using test::GantryPlan;

/// A cup from (0.4, 0.2) to (-0.3, 0.5).
GantryPlan carrying() {
    GantryPlan plan(cups({{"cup", at(0.4, 0.2)}}));
    plan.value("#p1", at(-0.3, 0.5));
    plan.pick("cup", at(0.4, 0.2), {"cup", "left"});
    plan.place("cup", at(-0.3, 0.5), {"cup", "#p1"});
    return plan;
}

TEST(RefinedSkill, HasTheNamesAndTheNumbersOfItsStep) {
    const std::vector<RefinedSkill> skills = carrying().skills();
    ASSERT_EQ(skills.size(), 2u);
    EXPECT_EQ(skills[1].name(), "place");
    EXPECT_TRUE(skills[0].parameters().empty());
    const auto parameters = skills[1].parameters();
    ASSERT_EQ(parameters.size(), 1u);
    EXPECT_EQ(parameters[0].first, "#p1");
    EXPECT_EQ(parameters[0].second.kind, "pose");
    EXPECT_EQ(parameters[0].second.numbers, (std::vector<double>{-0.3, 0.5, 0, 0, 0, 0, 1}));
}

TEST(RefinedSkill, IsNamedWithOrWithoutItsContinuousArguments) {
    const RefinedSkill place = carrying().skills()[1];
    EXPECT_TRUE(place.is({{"place", "cup", "#p1"}}));
    EXPECT_TRUE(place.is({{"place", "cup"}}));
    for (const ActionName& other :
         {ActionName{{"place"}}, ActionName{{"place", "cup", "#p2"}}, ActionName{{"place", "#p1"}},
          ActionName{{"place", "cup", "#p1", "#p1"}}, ActionName{{"pick", "cup"}}, ActionName{{}}})
        EXPECT_FALSE(place.is(other));
}

TEST(RefinedSkill, StartsOnlyWhereItsMotionBegins) {
    const RefinedSkill pick = carrying().skills()[0];
    const Configuration home = test::gantry_home();
    EXPECT_EQ(pick.refusal(home, {}), std::nullopt);
    EXPECT_EQ(pick.refusal(home, {{"cup", at(0.405, 0.2)}, {"elephant", at(9, 9)}}), std::nullopt);

    Configuration elsewhere = home;
    elsewhere[1] += 0.1;
    EXPECT_EQ(*pick.refusal(elsewhere, {}), "the robot is not where (pick cup left) begins: y is off by 0.1");
    EXPECT_EQ(pick.refusal(elsewhere, {}, {.robot = 0.2}), std::nullopt);
    EXPECT_EQ(*pick.refusal(home, {{"cup", at(0.4, 0.25)}}),
              "cup is 0.05 m from where (pick cup left) has it");
    Pose turned = at(0.4, 0.2);
    turned.rotate(Eigen::AngleAxisd(0.5, Vector3::UnitZ()));
    EXPECT_EQ(*pick.refusal(home, {{"cup", turned}}),
              "cup is turned by 0.5 against how (pick cup left) has it");
    EXPECT_EQ(pick.refusal(home, {{"cup", turned}}, {.turn = 10}), std::nullopt);
    EXPECT_THROW(static_cast<void>(pick.refusal({}, {})), std::invalid_argument);
}

TEST(RefinedSkill, WhatIsCarriedMustBeInTheHand) {
    const RefinedSkill place = carrying().skills()[1];
    Configuration home = test::gantry_home();
    home.back() = 0.02;  // the cup stops the fingers somewhere
    EXPECT_EQ(place.refusal(home, {{"cup", at(0, 0, test::kGantryHeight)}}), std::nullopt);
    EXPECT_TRUE(place.refusal(home, {{"cup", at(0.4, 0.2)}}));
}

TEST(RefinedSkill, NumbersThatAreNoneAreRefused) {
    const RefinedSkill pick = carrying().skills()[0];
    Configuration home = test::gantry_home();
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(pick.refusal(home, {{"cup", at(none, 0)}}));
    home[0] = none;
    EXPECT_TRUE(pick.refusal(home, {}));
}

TEST(RefinedSkill, SaysWhereToBeAndWhenTheGripperActs) {
    const TrajectoryDocument document = sample_document();
    const std::vector<RefinedSkill> skills = refined_skills(document);
    const RefinedSkill& place = skills[1];
    EXPECT_DOUBLE_EQ(place.duration(), document.plan[1].end - document.plan[1].start);
    ASSERT_EQ(place.events().size(), 1u);
    EXPECT_FALSE(place.events()[0].attach);
    EXPECT_EQ(place.events()[0].detach->body, "can");
    EXPECT_DOUBLE_EQ(place.events()[0].time, document.segments[6].end - document.plan[1].start);
    EXPECT_EQ(place.command(0).positions, skills[0].command(skills[0].duration()).positions);
    const RefinedSkill::Deviation off = place.deviation(1, place.command(1.1).positions);
    EXPECT_GT(off.amount, 0.001);
    EXPECT_EQ(place.deviation(1, place.command(1).positions).amount, 0);
}

TEST(RefinedSkill, ContinuousAnglesAreComparedRound) {
    GantryPlan plan = carrying();
    plan.document().robot.links[1].type = JointType::continuous;
    Configuration home = test::gantry_home();
    home[0] += 2 * std::numbers::pi;
    EXPECT_EQ(plan.skills()[0].refusal(home, {}), std::nullopt);
    EXPECT_TRUE(carrying().skills()[0].refusal(home, {}));
}

TEST(RefinedSkill, StepsThatAreNotSkillsOfTheirOwnAreRefused) {
    const auto motion = std::make_shared<const RefinedMotion>(carrying().document());
    EXPECT_THROW(RefinedSkill(motion, 2), std::invalid_argument);

    GantryPlan overlapping = carrying();
    for (TrajectoryDocument::Segment& segment : overlapping.document().segments) {
        if (segment.action == 0) segment.variables = {3};
        if (segment.action == 0) segment.knots.clear();
    }
    overlapping.document().plan[1].start = overlapping.document().plan[0].start;
    overlapping.document().segments[0].action = 1;
    EXPECT_THROW(overlapping.skills(), std::invalid_argument);

    GantryPlan moving = carrying();
    std::vector<Trajectory::Knot>& knots = moving.document().segments[2].knots;
    moving.document().segments[2].end = moving.document().plan[0].end = knots[1].time;
    knots.resize(2);
    EXPECT_THROW(moving.skills(), std::invalid_argument);
}

TEST(RefinedSkill, AStepWithoutMotionIsOver) {
    GantryPlan plan(cups({}));
    plan.begin("wait", {});
    const RefinedSkill wait = plan.skills().at(0);
    EXPECT_EQ(wait.duration(), 0);
    EXPECT_EQ(wait.refusal(test::gantry_home(), {}), std::nullopt);
}

}  // namespace
}  // namespace praxis::tamp
