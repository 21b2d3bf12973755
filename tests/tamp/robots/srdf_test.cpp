#include "tamp/robots/srdf.hpp"

#include <gtest/gtest.h>

#include "tamp/robots/read_robot.hpp"
#include "tests/tamp/robots/robot_checks.hpp"

namespace praxis::tamp {
namespace {

/// base -shoulder- upper -elbow- lower -wrist (fixed)- palm with two sliding fingers, one a mimic.
std::string arm() {
    std::string text = "<robot name=\"arm\">";
    for (const char* link : {"base", "upper", "lower", "palm", "left", "right"}) {
        text += "<link name=\"" + std::string(link) +
                "\"><collision><geometry><sphere radius=\"0.01\"/></geometry></collision></link>";
    }
    const auto joint = [&](const char* name, const char* type, const char* parent, const char* child,
                           const char* more) {
        text += "<joint name=\"" + std::string(name) + "\" type=\"" + type + "\"><parent link=\"" + parent +
                "\"/><child link=\"" + child + "\"/><origin xyz=\"0 0 1\"/><axis xyz=\"0 1 0\"/>" +
                "<limit lower=\"-1\" upper=\"2\" velocity=\"1\" effort=\"1\"/>" + more + "</joint>";
    };
    joint("shoulder", "revolute", "base", "upper", "");
    joint("elbow", "revolute", "upper", "lower", "");
    joint("wrist", "fixed", "lower", "palm", "");
    joint("left_slide", "prismatic", "palm", "left", "");
    joint("right_slide", "prismatic", "palm", "right", "<mimic joint=\"left_slide\" multiplier=\"-1\"/>");
    return text + "</robot>";
}

Robot read(const std::string& inside, const RobotOptions& options = {}) {
    return parse_robot({"a.urdf", arm()}, {"a.srdf", "<robot name=\"arm\">\n" + inside + "</robot>"},
                       options);
}

const std::string kGroups =
    "<group name=\"arm\"><chain base_link=\"base\" tip_link=\"palm\"/></group>\n"
    "<group name=\"fingers\"><link name=\"left\"/><link name=\"right\"/></group>\n";

TEST(Srdf, GroupsOfChainsLinksJointsAndGroups) {
    const Robot robot = read(kGroups +
                             "<group name=\"both\"><group name=\"arm\"/><group name=\"fingers\"/></group>"
                             "<group name=\"one\"><joint name=\"elbow\"/></group>"
                             "<group name=\"set\"><link name=\"base\"/></group>");
    ASSERT_EQ(robot.groups.size(), 4U);
    EXPECT_EQ(robot.groups[0].variables, (std::vector<int>{0, 1}));
    EXPECT_EQ(robot.groups[0].tip, robot.find_link("palm"));
    EXPECT_EQ(robot.groups[1].variables, std::vector<int>{2});
    EXPECT_EQ(robot.groups[2].name, "both");
    EXPECT_EQ(robot.groups[2].variables, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(robot.groups[3].variables, std::vector<int>{1});
    EXPECT_EQ(robot.groups[3].tip, robot.find_link("lower"));
}

TEST(Srdf, StatesAndEndEffectors) {
    const Robot robot =
        read(kGroups +
             "<group_state name=\"up\" group=\"arm\"><joint name=\"elbow\" value=\"0.5\"/></group_state>"
             "<group_state name=\"open\" group=\"fingers\"><joint name=\"left_slide\" value=\"1\"/>"
             "<joint name=\"right_slide\" value=\"1\"/></group_state>"
             "<end_effector name=\"hand\" parent_link=\"palm\" group=\"fingers\">"
             "<tool xyz=\"0 0 0.1\" rpy=\"0 0 1\"/></end_effector>");
    ASSERT_EQ(robot.states.size(), 2U);
    EXPECT_EQ(robot.states[0].positions, (Configuration{0, 0.5}));
    ASSERT_EQ(robot.end_effectors.size(), 1U);
    const EndEffector& hand = robot.end_effectors[0];
    EXPECT_EQ(hand.arm, "arm");
    EXPECT_EQ(hand.gripper, "fingers");
    EXPECT_TRUE(hand.tool.isApprox(pose_from_rpy({0, 0, 0.1}, {0, 0, 1})));
    EXPECT_EQ(hand.links,
              (std::vector<int>{robot.find_link("palm"), robot.find_link("left"), robot.find_link("right")}));
    EXPECT_EQ(hand.open, Configuration{1});
    EXPECT_EQ(hand.closed, Configuration{-1});
    // Both fingers slide by two metres.
    EXPECT_EQ(hand.max_opening, 4);
    EXPECT_EQ(robot.groups[1].tip, -1);
}

TEST(Srdf, AllowedCollisionsAreTheNeighboursAndThoseListed) {
    const Robot robot = read("<disable_collisions link1=\"palm\" link2=\"base\" reason=\"Never\"/>");
    const auto may_collide = [&](const char* first, const char* second) {
        return robot.may_collide(robot.find_link(first), robot.find_link(second));
    };
    EXPECT_FALSE(may_collide("base", "palm"));
    EXPECT_FALSE(may_collide("base", "upper"));
    EXPECT_TRUE(may_collide("base", "lower"));
    const Robot other = read(
        "<disable_default_collisions link=\"lower\"/><enable_collisions link1=\"lower\" link2=\"base\"/>"
        "<disable_collisions link1=\"left\" link2=\"right\"/>");
    EXPECT_TRUE(other.may_collide(other.find_link("base"), other.find_link("lower")));
    EXPECT_FALSE(other.may_collide(other.find_link("left"), other.find_link("lower")));
    EXPECT_TRUE(other.may_collide(other.find_link("left"), other.find_link("upper")));
}

TEST(Srdf, APlanarVirtualJointIsAMobileBase) {
    const std::string base =
        "<virtual_joint name=\"ground\" type=\"planar\" parent_frame=\"world\" child_link=\"base\"/>";
    const Robot robot = read(base + kGroups + "<group name=\"base\"><joint name=\"ground\"/></group>" +
                                 "<group_state name=\"there\" group=\"base\"><joint name=\"ground\" "
                                 "value=\"3 4 1\"/></group_state>",
                             {.limits = {.position = {{"ground/x", {-5, 5}}}}});
    ASSERT_EQ(robot.variables.size(), 6U);
    EXPECT_EQ(robot.links[0].name, "world");
    EXPECT_EQ(robot.variables[0].upper, 5);
    EXPECT_EQ(robot.groups[2].variables, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(robot.groups[2].tip, robot.find_link("base"));
    EXPECT_EQ(robot.states[0].positions, (Configuration{3, 4, 1}));
    Configuration q(6, 0.25);
    const Pose fixed = link_pose(read(kGroups), Configuration(3, 0.25), 3);
    q[0] = 3;
    q[1] = 4;
    q[2] = 1;
    EXPECT_TRUE(
        (pose_from_rpy({3, 4, 0}, {0, 0, 1}) * fixed).isApprox(link_pose(robot, q, robot.find_link("palm"))));
    EXPECT_EQ(
        read("<virtual_joint name=\"ground\" type=\"fixed\" parent_frame=\"world\" child_link=\"base\"/>")
            .variables.size(),
        3U);
}

TEST(Srdf, BrokenFilesAreRefusedWithPlaceAndMend) {
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {"<group name=\"g\"><joint name=\"elbov\"/></group>",
         {"a.srdf:2", "unknown joint 'elbov'", "did you mean 'elbow'"}},
        {"<group name=\"g\"><link name=\"x\"/></group>", {"unknown link 'x'"}},
        {"<group name=\"g\"><group name=\"h\"/></group>", {"unknown group 'h'"}},
        {"<group name=\"g\"><group name=\"h\"/></group><group name=\"h\"><group name=\"g\"/></group>",
         {"has itself as a subgroup"}},
        {"<group name=\"g\"/><group name=\"g\"/>", {"another group named 'g'"}},
        {"<group name=\"g\"><chain base_link=\"lower\" tip_link=\"upper\"/></group>",
         {"'upper' is not below 'lower'"}},
        {kGroups + "<group_state name=\"s\" group=\"x\"/>", {"a.srdf:4", "unknown group 'x'"}},
        {kGroups + "<group_state name=\"s\" group=\"arm\"><joint name=\"elbow\" value=\"9\"/></group_state>",
         {"outside of the limits of joint 'elbow'"}},
        {kGroups +
             "<group_state name=\"s\" group=\"arm\"><joint name=\"elbow\" value=\"nan\"/></group_state>",
         {"'nan' is no finite number"}},
        {kGroups +
             "<group_state name=\"s\" group=\"arm\"><joint name=\"elbow\" value=\"1 2\"/></group_state>",
         {"needs 1 numbers"}},
        {kGroups + "<end_effector name=\"e\" parent_link=\"base\" group=\"fingers\"/>", {"parent_group"}},
        {kGroups + "<end_effector name=\"e\" parent_link=\"palm\" group=\"fingers\"><tool xyz=\"1 "
                   "2\"/></end_effector>",
         {"'xyz' needs 3 numbers"}},
        {"<disable_collisions link1=\"base\" link2=\"bse\"/>", {"unknown link 'bse'", "did you mean 'base'"}},
        {"<disable_collisions link1=\"base\" link2=\"base\"/>", {"never collides with itself"}},
        {"<virtual_joint name=\"v\" type=\"floating\" parent_frame=\"w\" child_link=\"base\"/>",
         {"'floating'", "planar"}},
        {"<virtual_joint name=\"v\" type=\"planar\" parent_frame=\"upper\" child_link=\"base\"/>",
         {"'upper' already"}},
        {"<virtual_joint name=\"v\" type=\"planar\" parent_frame=\"w\" child_link=\"palm\"/>", {"root link"}},
        {"<group name=\"g\">", {"well-formed"}},
    };
    for (const auto& [inside, words] : cases) {
        const std::string message = input_error([&, &text = inside] { read(text); });
        for (const std::string& word : words) {
            EXPECT_NE(message.find(word), std::string::npos) << "no " << word << " in: " << message;
        }
    }
}

TEST(ReadRobot, WithoutSrdfGroupsFollowFromTheChains) {
    const Robot robot = parse_robot({"a.urdf", arm()}, {});
    ASSERT_EQ(robot.groups.size(), 2U);
    EXPECT_EQ(robot.groups[0].name, "arm");
    EXPECT_EQ(robot.groups[0].variables, (std::vector<int>{0, 1}));
    EXPECT_EQ(robot.groups[0].tip, robot.find_link("palm"));
    EXPECT_EQ(robot.groups[1].name, "gripper");
    EXPECT_EQ(robot.groups[1].variables, std::vector<int>{2});
    EXPECT_EQ(robot.groups[1].tip, -1);
}

TEST(ReadRobot, SamplingFindsPairsThatNeedNoChecks) {
    // The lower arm is as long as the upper one and may fold back onto the base; the tips of one rigid part
    // do not move against each other; the far wall is out of reach.
    const auto link = [](const std::string& name, const std::string& xyz) {
        return "<link name=\"" + name + "\"><collision><origin xyz=\"" + xyz +
               "\"/><geometry><sphere radius=\"0.2\"/></geometry></collision></link>";
    };
    const auto joint = [](const std::string& name, const std::string& type, const std::string& parent,
                          const std::string& child, const std::string& xyz) {
        return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
               "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz +
               "\"/><axis xyz=\"0 0 1\"/></joint>";
    };
    const std::string text =
        "<robot name=\"r\">" + link("base", "0 0 0") + link("upper", "0.5 0 0") + link("lower", "0.5 0 0") +
        link("tip", "0 0 0") + link("wall", "5 0 0") + joint("a", "continuous", "base", "upper", "0 0 0") +
        joint("b", "continuous", "upper", "lower", "1 0 0") + joint("c", "fixed", "lower", "tip", "1 0 0") +
        joint("d", "fixed", "base", "wall", "0 0 0") + "</robot>";
    const Robot robot = parse_robot({"r.urdf", text}, {});
    const auto may_collide = [&](const char* first, const char* second) {
        return robot.may_collide(robot.find_link(first), robot.find_link(second));
    };
    EXPECT_FALSE(may_collide("base", "upper"));
    EXPECT_TRUE(may_collide("base", "tip"));
    EXPECT_FALSE(may_collide("lower", "tip"));
    EXPECT_FALSE(may_collide("base", "wall"));
    EXPECT_FALSE(may_collide("wall", "tip"));
    const Robot again = parse_robot({"r.urdf", text}, {});
    EXPECT_EQ(robot.allowed_collisions, again.allowed_collisions);
}

}  // namespace
}  // namespace praxis::tamp
