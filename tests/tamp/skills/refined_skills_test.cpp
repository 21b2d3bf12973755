#include "tamp/skills/refined_skills.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/tamp/samples/sample_document.hpp"
#include "tests/tamp/skills/recording_driver.hpp"
#include "tests/tamp/support/gantry.hpp"

namespace praxis::tamp {
namespace {

using test::at;
using test::cups;
using test::GantryPlan;
using test::RecordingDriver;
using Status = Execution::Status;

const ActionName kPick{{"pick", "cup"}}, kPlace{{"place", "cup"}};

TrajectoryDocument carrying() {
    GantryPlan plan(cups({{"cup", at(0.4, 0.2)}}));
    plan.pick("cup", at(0.4, 0.2), {"cup"});
    plan.place("cup", at(-0.3, 0.5), {"cup"});
    return plan.document();
}

struct Gantry {
    explicit Gantry(const SimulationOptions& simulation = {}, const SkillExecution& options = {})
        : driver(carrying(), simulation), skills(planned(carrying()), test::gantry(), driver, options) {}
    RecordingDriver driver;
    RefinedSkills skills;
};

/// From command to command, velocities change within the limits, and positions as the velocities say.
void expect_smooth(const RecordingDriver& driver, const Robot& robot) {
    ASSERT_FALSE(driver.commands.empty());
    const std::vector<RobotCommand>& commands = driver.commands;
    for (std::size_t i = 1; i < commands.size(); ++i) {
        const double step = driver.times[i] - driver.times[i - 1];
        for (std::size_t v = 0; v < robot.variables.size(); ++v) {
            const double before = commands[i - 1].velocities[v], after = commands[i].velocities[v];
            const double limit = robot.variables[v].max_acceleration * 0.004 * 1.0001;
            ASSERT_LE(std::abs(after - before), limit + 1e-9) << "command " << i << ", variable " << v;
            const double moved = commands[i].positions[v] - commands[i - 1].positions[v];
            ASSERT_LE(std::abs(moved), 0.004 * std::max(std::abs(before), std::abs(after)) + limit * 0.004)
                << i << ", step " << step;
        }
    }
}

bool at_rest(const RobotCommand& command) {
    return std::ranges::all_of(command.velocities, [](double velocity) { return velocity == 0; });
}

TEST(RefinedSkills, CarryOutAPlan) {
    Gantry gantry({.noise = 0.001});
    EXPECT_EQ(gantry.skills.execute(kPick, {}, {}).status, Status::done);
    EXPECT_TRUE(gantry.driver.holds("cup"));
    EXPECT_EQ(gantry.skills.execute(kPlace, {}, {}).status, Status::done);
    EXPECT_FALSE(gantry.driver.holds("cup"));
    EXPECT_TRUE(gantry.driver.bodies().at("cup").isApprox(at(-0.3, 0.5), 1e-9));
    expect_smooth(gantry.driver, test::gantry());
    EXPECT_NEAR(gantry.driver.seconds(), carrying().duration(), 1e-9);
}

TEST(RefinedSkills, CarryOutAPlanOfAnArm) {
    RecordingDriver driver(sample_document());
    Robot robot = sample_robot();
    for (Variable& variable : robot.variables) variable.max_acceleration = 20;
    RefinedSkills skills(planned(sample_document()), robot, driver);
    EXPECT_EQ(skills.execute({{"pick", "can", "table"}}, {}, {}).status, Status::done);
    EXPECT_EQ(skills.execute({{"place", "can", "shelf"}}, {}, {}).status, Status::done);
    const TrajectoryDocument document = sample_document();
    const Replay replay(document);
    const Pose planned_pose =
        replay.bodies_at(document.duration())[static_cast<std::size_t>(document.find_body("can"))];
    EXPECT_TRUE(driver.bodies().at("can").isApprox(planned_pose, 1e-9));
}

TEST(RefinedSkills, RefuseWhatIsNotKnown) {
    Gantry gantry;
    const std::vector<double> parameters = {1};
    EXPECT_EQ(gantry.skills.execute({{"juggle", "cup"}}, {}, {}).message,
              "no motion is known for (juggle cup)");
    EXPECT_EQ(gantry.skills.execute(kPick, parameters, {}).status, Status::illegal);
    EXPECT_TRUE(gantry.driver.commands.empty());
}

TEST(RefinedSkills, RefuseAWrongStart) {
    Gantry gantry;
    const Execution place = gantry.skills.execute(kPlace, {}, {});
    EXPECT_EQ(place.status, Status::illegal);
    EXPECT_NE(place.message.find("cup is"), std::string::npos) << place.message;
    gantry.driver.put("cup", at(0.5, 0.2));
    EXPECT_EQ(gantry.skills.execute(kPick, {}, {}).status, Status::illegal);
    gantry.driver.put("cup", at(0.4, 0.2));
    gantry.driver.put_robot({0.1, 0, test::kGantryHeight, test::kOpen});
    EXPECT_EQ(gantry.skills.execute(kPick, {}, {}).status, Status::illegal);
    gantry.driver.put_robot({0, 0, test::kGantryHeight, 0});
    const Execution closed = gantry.skills.execute(kPick, {}, {});
    EXPECT_EQ(closed.message, "the robot is not where (pick cup) begins: finger is off by 0.06");
    EXPECT_TRUE(gantry.driver.commands.empty());
    EXPECT_EQ(gantry.driver.seconds(), 0);
}

RC_GTEST_PROP(RefinedSkills, AreBroughtToRestWithinTheLimits, ()) {
    Gantry gantry;
    std::stop_source stop;
    const auto moment = *rc::gen::inRange<std::size_t>(1, 800);
    gantry.driver.on_command = [&] {
        if (gantry.driver.commands.size() == moment) stop.request_stop();
    };
    const Execution pick = gantry.skills.execute(kPick, {}, stop.get_token());
    RC_PRE(stop.stop_requested());
    RC_ASSERT(pick.status == Status::failed);
    RC_ASSERT(pick.message == "told to stop");
    RC_ASSERT(at_rest(gantry.driver.commands.back()));
    expect_smooth(gantry.driver, test::gantry());
    RC_ASSERT(!::testing::Test::HasFailure());
    // Half a metre a second takes a quarter of one; a corner that needs all acceleration comes first.
    RC_ASSERT(gantry.driver.commands.size() - moment <= 150u);
}

RC_GTEST_PROP(RefinedSkills, StayOnTheirPathWhenTheyAreStopped, ()) {
    Gantry gantry;
    std::stop_source stop;
    const auto moment = *rc::gen::inRange<std::size_t>(1, 300);
    gantry.driver.on_command = [&] {
        if (gantry.driver.commands.size() == moment) stop.request_stop();
    };
    gantry.skills.execute(kPick, {}, stop.get_token());
    const RefinedSkill pick = refined_skills(carrying())[0];
    double nearest = 1;
    for (double time = 0; time < pick.duration(); time += 0.0005)
        nearest = std::min(nearest, pick.deviation(time, gantry.driver.commands.back().positions).amount);
    RC_ASSERT(nearest < 0.5 * 0.0005);
}

TEST(RefinedSkills, DoNotStartWhenAlreadyTold) {
    Gantry gantry;
    std::stop_source stop;
    stop.request_stop();
    EXPECT_EQ(gantry.skills.execute(kPick, {}, stop.get_token()).status, Status::failed);
    EXPECT_TRUE(gantry.driver.commands.empty());
}

TEST(RefinedSkills, AHandThatSlipsGoesBackAndMayTryAgain) {
    Gantry gantry({.slip = 0.5, .seed = 7});
    int failures = 0;
    for (Execution pick{Status::failed, ""}; pick.status != Status::done; ++failures) {
        ASSERT_LT(failures, 20);
        pick = gantry.skills.execute(kPick, {}, {});
        ASSERT_NE(pick.status, Status::illegal) << pick.message;
        if (pick.status == Status::failed) {
            EXPECT_EQ(pick.message, "the hand slips off cup");
            EXPECT_EQ(gantry.driver.opened, failures + 1);
            EXPECT_EQ(gantry.driver.positions(), test::gantry_home());
        }
    }
    EXPECT_GT(failures, 1);
    EXPECT_TRUE(gantry.driver.holds("cup"));
    expect_smooth(gantry.driver, test::gantry());
}

TEST(RefinedSkills, AnEmptyGraspIsAFailure) {
    Gantry gantry({}, {.start = {.body = 0.1}});
    gantry.driver.put("cup", at(0.45, 0.2));
    const Execution pick = gantry.skills.execute(kPick, {}, {});
    EXPECT_EQ(pick.status, Status::failed);
    EXPECT_EQ(pick.message, "the hand closes on nothing: cup is not there");
    EXPECT_TRUE(gantry.driver.bodies().at("cup").isApprox(at(0.45, 0.2)));
}

TEST(RefinedSkills, ARobotThatIsPushedStops) {
    Gantry gantry;
    gantry.driver.on_command = [&] {
        if (gantry.driver.commands.size() == 100) gantry.driver.push = 0.2;
    };
    const Execution pick = gantry.skills.execute(kPick, {}, {});
    EXPECT_EQ(pick.status, Status::failed);
    EXPECT_NE(pick.message.find("off its path: x by 0.2"), std::string::npos) << pick.message;
    EXPECT_TRUE(at_rest(gantry.driver.commands.back()));
    EXPECT_LT(gantry.driver.commands.size(), 200u);
    expect_smooth(gantry.driver, test::gantry());
}

TEST(RefinedSkills, AFaultOfTheDriverEndsTheSkill) {
    Gantry gantry;
    gantry.driver.refuse_from = 50;
    const Execution pick = gantry.skills.execute(kPick, {}, {});
    EXPECT_EQ(pick.status, Status::failed);
    EXPECT_EQ(pick.message, "the motors are off");
    EXPECT_EQ(gantry.driver.commands.size(), 50u);
}

TEST(RefinedSkills, AnotherRobotIsNoticed) {
    RecordingDriver driver(carrying());
    RefinedSkills skills(planned(carrying()), sample_robot(), driver);
    EXPECT_THROW(skills.execute(kPick, {}, {}), std::invalid_argument);
    RecordingDriver arm(sample_document());
    RefinedSkills others(planned(carrying()), test::gantry(), arm);
    EXPECT_THROW(others.execute(kPick, {}, {}), std::invalid_argument);
    EXPECT_TRUE(driver.commands.empty());
}

TEST(RefinedSkills, OptionsAreChecked) {
    RecordingDriver driver(carrying());
    for (const SkillExecution& wrong :
         {SkillExecution{.period = 0}, SkillExecution{.tracking = std::nan("")}})
        EXPECT_THROW(RefinedSkills(planned(carrying()), test::gantry(), driver, wrong),
                     std::invalid_argument);
    for (const SimulationOptions& wrong :
         {SimulationOptions{.noise = -1}, SimulationOptions{.slip = 1.5}, SimulationOptions{.reach = 0}})
        EXPECT_THROW(SimulatedDriver(carrying(), wrong), std::invalid_argument);
    EXPECT_THROW(driver.put("elephant", at(0, 0)), std::invalid_argument);
    EXPECT_THROW(driver.put_robot({1}), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
