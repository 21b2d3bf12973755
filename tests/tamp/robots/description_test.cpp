#include "tamp/robots/description.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>

#include "tamp/robots/dh.hpp"
#include "tamp/robots/limits.hpp"
#include "tamp/robots/mount.hpp"
#include "tests/tamp/robots/robot_checks.hpp"

namespace praxis::tamp {
namespace {

const std::string kArm = R"(robot: arm2
convention: standard
base: {link: foot, shapes: [{sphere: {radius: 0.1}}]}
rows:
  - {joint: shoulder, link: upper, a: 1, limits: [-3, 3], velocity: 2, acceleration: 5,
     shapes: [{capsule: {radius: 0.05, from: [-1, 0, 0], to: [0, 0, 0]}}]}
  - {joint: elbow, type: continuous, link: lower, a: 0.5}
  - {joint: out, type: prismatic, link: finger, limits: [0, 0.1]}
  - {joint: in, type: prismatic, link: thumb, parent: lower, mimic: {joint: out, multiplier: -1}}
groups: [{name: arm, joints: [shoulder, elbow], tip: lower}, {name: gripper, joints: [out]}]
states: [{name: home, group: arm, positions: [0, 1]}]
end_effectors:
  - {name: hand, link: lower, arm: arm, gripper: gripper, tool: {xyz: [0.5, 0, 0.1]}, links: [finger, thumb],
     max_opening: 0.2, open: [0.1], closed: [0]}
allowed_collisions: [[foot, finger]]
)";

Robot parse(const std::string& text) {
    return parse_description({"r.yaml", text});
}

TEST(Description, AnArmWithEverything) {
    const Robot robot = parse(kArm);
    EXPECT_EQ(robot.name, "arm2");
    ASSERT_EQ(robot.variables.size(), 3U);
    EXPECT_EQ(robot.variables[0].max_acceleration, 5);
    EXPECT_TRUE(robot.variables[1].continuous);
    EXPECT_EQ(robot.groups[0].tip, robot.find_link("lower"));
    EXPECT_EQ(robot.states[0].positions, (Configuration{0, 1}));
    const EndEffector& hand = robot.end_effectors.at(0);
    EXPECT_EQ(hand.max_opening, 0.2);
    EXPECT_EQ(hand.open, Configuration{0.1});
    EXPECT_EQ(hand.links.size(), 3U);
    EXPECT_FALSE(robot.may_collide(robot.find_link("foot"), robot.find_link("finger")));
    EXPECT_TRUE(robot.may_collide(robot.find_link("foot"), robot.find_link("thumb")));
    // Elbow at right angles: the finger is half a metre to the left of the elbow, and 0.1 above it.
    const Configuration q = {0, std::numbers::pi / 2, 0.1};
    EXPECT_LT((link_pose(robot, q, robot.find_link("finger")).translation() - Vector3(1, 0.5, 0.1)).norm(),
              1e-12);
    EXPECT_LT((link_pose(robot, q, robot.find_link("thumb")).translation() - Vector3(1, 0.5, -0.1)).norm(),
              1e-12);
    // The capsule of the upper arm reaches from the shoulder to the elbow.
    const PlacedShape& upper = robot.links[1].collision.at(0);
    EXPECT_EQ(std::get<Capsule>(upper.shape).length, 1);
    const Pose placed = link_pose(robot, {std::vector<double>{0, 0, 0}}, 1) * upper.pose;
    EXPECT_LT((placed * Vector3(0, 0, 0.5) - Vector3(1, 0, 0)).norm(), 1e-12);
    EXPECT_LT((placed * Vector3(0, 0, -0.5)).norm(), 1e-12);
    EXPECT_GT(robot.links[1].balls.size(), 1U);
}

TEST(Description, BothConventionsAreTheProductsOfTheirRows) {
    Random random(3);
    for (const DhConvention convention : {DhConvention::standard, DhConvention::modified}) {
        DhTable table{.name = "r", .convention = convention};
        for (int i = 0; i < 6; ++i) {
            table.rows.push_back({.joint = "j" + std::to_string(i),
                                  .link = "l" + std::to_string(i),
                                  .type = i % 3 == 2 ? JointType::prismatic : JointType::revolute,
                                  .a = uniform(random, -1, 1),
                                  .alpha = uniform(random, -3, 3),
                                  .d = uniform(random, -1, 1),
                                  .theta = uniform(random, -3, 3),
                                  .limits = {.lower = -2, .upper = 2}});
        }
        const Robot robot = make_dh_robot(table);
        for (int i = 0; i < 20; ++i) {
            const Configuration q = random_configuration(robot, random);
            // Rows as in the textbooks: four elementary motions.
            Pose product = Pose::Identity();
            for (std::size_t row = 0; row < table.rows.size(); ++row) {
                const DhRow& dh = table.rows[row];
                const bool slides = dh.type == JointType::prismatic;
                const Pose z = pose_from_rpy({0, 0, dh.d + (slides ? q[row] : 0)},
                                             {0, 0, dh.theta + (slides ? 0 : q[row])});
                const Pose x = pose_from_rpy({dh.a, 0, 0}, {dh.alpha, 0, 0});
                product = convention == DhConvention::standard ? product * z * x : product * x * z;
            }
            const int last = static_cast<int>(robot.links.size()) - 1;
            EXPECT_LT((product.matrix() - link_pose(robot, q, last).matrix()).cwiseAbs().maxCoeff(), 1e-12);
        }
        EXPECT_EQ(robot.links.back().name, convention == DhConvention::standard ? "l5_end" : "l5");
    }
}

TEST(Description, WrongTablesAreRefused) {
    const DhRow row{.joint = "j", .link = "l"};
    EXPECT_THROW(make_dh_robot({.name = "r", .rows = {row, row}}), std::invalid_argument);
    EXPECT_THROW(make_dh_robot({.name = "r", .rows = {{.joint = "j"}}}), std::invalid_argument);
    EXPECT_THROW(make_dh_robot({.name = "r", .rows = {{.joint = "j", .link = "l", .parent = "x"}}}),
                 std::invalid_argument);
    EXPECT_THROW(make_dh_robot({.name = "r", .rows = {{.joint = "j", .link = "l", .mimic = "x"}}}),
                 std::invalid_argument);
    EXPECT_THROW(make_dh_robot({.name = "r", .rows = {{.joint = "j", .link = "l", .a = std::nan("")}}}),
                 std::invalid_argument);
}

TEST(Description, BrokenFilesAreRefusedWithPlaceAndMend) {
    const auto changed = [](const std::string& from, const std::string& to) {
        std::string text = kArm;
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return text.replace(at, from.size(), to);
    };
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {"", {"empty"}},
        {"- 1", {"r.yaml:1", "map"}},
        {"robot: [", {"r.yaml", "no YAML"}},
        {"robot: r", {"needs 'rows'"}},
        {changed("standard", "classic"), {"r.yaml:2", "'classic'", "modified"}},
        {changed("limits: [-3, 3]", "limits: [3, -3]"), {"r.yaml:5", "lower limit above"}},
        {changed("limits: [-3, 3], ", ""), {"needs 'limits'", "shoulder"}},
        {changed("velocity: 2", "velocity: 0"), {"above 0"}},
        {changed("velocity: 2", "velocity: .nan"), {"finite"}},
        {changed("a: 1,", "a: one,"), {"r.yaml:5", "'one'"}},
        {changed("link: upper", "lnk: upper"), {"'lnk'", "did you mean 'link'"}},
        {changed("link: lower", "link: upper"), {"two links are named 'upper'"}},
        {changed("radius: 0.05", "radius: -1"), {"r.yaml:6", "above 0"}},
        {changed("to: [0, 0, 0]", "to: [-1, 0, 0]"), {"ends of a capsule must differ"}},
        {changed("to: [0, 0, 0]", "to: [0, 0]"), {"3 numbers"}},
        {changed("parent: lower", "parent: lwer"), {"unknown link 'lwer'"}},
        {changed("joint: out, multiplier", "joint: oot, multiplier"), {"cannot mimic 'oot'"}},
        {changed("[shoulder, elbow]", "[shoulder, elbw]"),
         {"unknown moving joint 'elbw'", "did you mean 'elbow'"}},
        {changed("positions: [0, 1]", "positions: [0]"), {"must have 2 numbers"}},
        {changed("positions: [0, 1]", "positions: [9, 1]"), {"outside of the limits"}},
        {changed("arm: arm", "arm: leg"), {"unknown group 'leg'"}},
        {changed("[[foot, finger]]", "[[foot, foot]]"), {"never collides with itself"}},
        {changed("[[foot, finger]]", "[[foot]]"), {"pair"}},
    };
    for (const auto& [text, words] : cases) {
        const std::string message = input_error([&, &broken = text] { parse(broken); });
        for (const std::string& word : words) {
            EXPECT_NE(message.find(word), std::string::npos) << "no " << word << " in: " << message;
        }
    }
    for (std::size_t length = 0; length < kArm.size(); length += 7) {
        try {
            parse(kArm.substr(0, length));
        } catch (const InputError&) {
        }
    }
}

TEST(Limits, AreReadByName) {
    const MotionLimits limits = parse_limits({"l.yaml", "position: {a: [-1, 2]}\nacceleration: {b: 3}\n"});
    EXPECT_EQ(limits.position.at("a"), (std::pair<double, double>{-1, 2}));
    EXPECT_EQ(limits.acceleration.at("b"), 3);
    EXPECT_TRUE(limits.velocity.empty());
    const auto message = [](const char* text) {
        return input_error([&] { parse_limits({"l.yaml", text}); });
    };
    EXPECT_NE(message("accelerations: {b: 3}").find("did you mean 'acceleration'"), std::string::npos);
    EXPECT_NE(message("velocity: {b: -3}").find("above 0"), std::string::npos);
    EXPECT_NE(message("position: {b: [1, 0]}").find("lower end above"), std::string::npos);
}

TEST(Mount, TwoArmsOnOneTable) {
    Robot table{.name = "table", .links = {{.name = "top"}}};
    const Robot arm = parse(kArm);
    const Pose left = pose_from_rpy({0, 1, 0.7}, {0, 0, 0.3});
    mount(table, arm, 0, left, "left_");
    mount(table, arm, 0, pose_from_rpy({0, -1, 0.7}, Vector3::Zero()), "right_");
    EXPECT_EQ(table.variables.size(), 6U);
    EXPECT_EQ(table.groups.size(), 4U);
    EXPECT_EQ(table.end_effectors.at(1).gripper, "right_gripper");
    EXPECT_EQ(table.groups[2].variables, (std::vector<int>{3, 4}));
    Random random(4);
    const Configuration q = random_configuration(table, random);
    const int finger = table.find_link("left_finger");
    const Pose expected = left * link_pose(arm, std::span(q).first(3), arm.find_link("finger"));
    EXPECT_TRUE(link_pose(table, q, finger).isApprox(expected, 1e-12));
    EXPECT_TRUE(table.may_collide(finger, table.find_link("right_finger")));
    EXPECT_FALSE(table.may_collide(table.find_link("right_foot"), table.find_link("right_finger")));
    EXPECT_THROW(mount(table, arm, 0, left, "left_"), std::invalid_argument);
    EXPECT_THROW(mount(table, arm, 99, left, "third_"), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
