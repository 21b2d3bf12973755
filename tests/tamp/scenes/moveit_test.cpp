#include "tamp/scenes/moveit.hpp"

#include <gtest/gtest.h>

#include "parser/diagnostic.hpp"

namespace praxis::tamp {
namespace {

using Kind = Participant::Kind;

std::shared_ptr<const Robot> arm() {
    Robot robot;
    robot.name = "arm";
    robot.base.translation().x() = 10;
    robot.links = {{.name = "base"},
                   {.name = "upper", .parent_joint = 0},
                   {.name = "lower", .parent_joint = 1},
                   {.name = "hand", .parent_joint = 2}};
    robot.joints = {{.name = "shoulder", .type = JointType::revolute, .parent = 0, .child = 1, .variable = 0},
                    {.name = "elbow", .type = JointType::revolute, .parent = 1, .child = 2, .variable = 1},
                    {.name = "wrist", .parent = 2, .child = 3}};
    robot.variables = {{.name = "shoulder", .lower = -3, .upper = 3},
                       {.name = "elbow", .lower = -3, .upper = 3}};
    return std::make_shared<const Robot>(std::move(robot));
}

const std::string kScene = R"(
robot_state:
  joint_state: {name: [shoulder, elbow, wrist], position: [0.1, 0.2, 0.9]}
allowed_collision_matrix:
  entry_names: [upper, gone, lower, can]
  entry_values:
    - [false, true, true, true]
    - [true, true, true, true]
    - [true, true, false, false]
    - [true, true, false, false]
world:
  collision_objects:
    - id: can
      primitives: [{type: cylinder, dimensions: [0.14, 0.03]}]
      primitive_poses: [{position: [1, 2, 3], orientation: [0, 0, 1, 0]}]
    - id: lamp
      header: {frame_id: base}
      primitives:
        - {type: 1, dimensions: [0.1, 0.2, 0.3]}
        - {type: sphere, dimensions: [0.4]}
      primitive_poses:
        - {position: {x: 1, y: 0, z: 0}, orientation: {x: 0, y: 0, z: 0, w: 1}}
        - {position: {x: 1, y: 0, z: 0.5}, orientation: {x: 0, y: 0, z: 0, w: 1}}
    - id: wedge
      pose: {position: [0, 0, 1], orientation: [0, 0, 0, 1]}
      meshes: [{vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, 2]]}]
      mesh_poses: [{position: [0, 0, 1], orientation: [0, 0, 0, 1]}]
)";

const std::string kRequest = R"(
group_name: both
start_state:
  joint_state: {name: [elbow], position: [0.3]}
goal_constraints:
  - joint_constraints: [{joint_name: elbow, position: 2}, {joint_name: shoulder, position: 1}]
planner_id: any
)";

MoveItProblem read(const std::string& scene, const std::string& request) {
    return read_moveit_problem(arm(), {"scene.yaml", scene}, {"request.yaml", request});
}

TEST(MoveIt, ReadsObjectsWithTheirShapesAndPoses) {
    const MoveItProblem problem = read(kScene, kRequest);
    const World& world = *problem.world;
    ASSERT_EQ(world.size(), 3U);
    const BodyState& can = world[0];
    EXPECT_EQ(can.model->name, "can");
    const auto& cylinder = std::get<Cylinder>(can.model->shapes[0].shape);
    EXPECT_EQ(cylinder.length, 0.14);
    EXPECT_EQ(cylinder.radius, 0.03);
    EXPECT_TRUE(can.pose.isApprox(pose_from_quaternion({1, 2, 3}, {0, 0, 1, 0})));
    EXPECT_FALSE(can.model->balls.empty());
    const BodyState& lamp = world[1];
    EXPECT_TRUE(lamp.pose.translation().isApprox(Vector3(11, 0, 0)));
    EXPECT_EQ(std::get<Box>(lamp.model->shapes[0].shape).size, Vector3(0.1, 0.2, 0.3));
    EXPECT_TRUE(lamp.model->shapes[1].pose.translation().isApprox(Vector3(0, 0, 0.5)));
    const BodyState& wedge = world[2];
    EXPECT_EQ(std::get<std::shared_ptr<const Mesh>>(wedge.model->shapes[0].shape)->triangles.size(), 1U);
    EXPECT_TRUE((wedge.pose * wedge.model->shapes[0].pose).translation().isApprox(Vector3(0, 0, 2)));
}

TEST(MoveIt, ReadsStartGoalAndGroup) {
    const MoveItProblem problem = read(kScene, kRequest);
    EXPECT_EQ(problem.start, (Configuration{0.1, 0.3}));
    const Group& group = problem.robot->groups[static_cast<std::size_t>(problem.group)];
    EXPECT_EQ(group.name, "both");
    EXPECT_EQ(group.variables, (std::vector<int>{0, 1}));
    EXPECT_EQ(group.tip, 2);
    EXPECT_EQ(problem.goals, (std::vector<Configuration>{{1, 2}}));
}

TEST(MoveIt, TheMatrixAllowsLinksAndBodies) {
    const MoveItProblem problem = read(kScene, kRequest);
    EXPECT_FALSE(problem.robot->may_collide(1, 2));
    EXPECT_TRUE(problem.robot->may_collide(0, 2));
    EXPECT_TRUE(problem.world->allowed({Kind::link, 1}, {Kind::body, 0}));
    EXPECT_FALSE(problem.world->allowed({Kind::link, 2}, {Kind::body, 0}));
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), with);
}

std::string complaint(const std::string& scene, const std::string& request) {
    try {
        read(scene, request);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(MoveIt, ErrorsNamePlaceAndMend) {
    const auto scene = [&](const std::string& old, const std::string& with) {
        return complaint(replaced(kScene, old, with), kRequest);
    };
    const auto request = [&](const std::string& old, const std::string& with) {
        return complaint(kScene, replaced(kRequest, old, with));
    };
    const auto expect = [](const std::string& message, const std::string& words) {
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect(scene("cylinder", "cone"), "scene.yaml:14:27: error: collision object 'can' has a primitive");
    expect(scene("0.03]", "-0.03]"), "a dimension must be above 0");
    expect(scene("0.03]", ".nan]"), "must be a finite number, not '.nan'");
    expect(scene("0.03]", "0.03, 1]"), "must have 2 numbers, not 3");
    expect(scene("[0, 0, 1, 0]", "[0, 0, 0, 0]"), "quaternion that is not zero");
    expect(scene("id: lamp", "id: can"), "'can' is there already");
    expect(scene("frame_id: base", "frame_id: odom"), "frame 'odom'");
    expect(scene("[[0, 1, 2]]", "[[0, 1, 3]]"), "a vertex that is not there");
    expect(scene("[shoulder, elbow, wrist]", "[shoulder, elbw, wrist]"), "did you mean 'elbow'?");
    expect(scene("    - [true, true, false, false]\n", ""), "one row a name");
    expect(scene("world:\n", "world:\n  - ["), "no YAML");
    expect(request("joint_name: elbow", "joint_name: elbo"), "did you mean 'elbow'?");
    expect(request("joint_name: elbow", "joint_name: shoulder"), "'shoulder' twice");
    expect(request("group_name: both\n", ""), "needs 'group_name'");
    expect(complaint("", kRequest), "is empty");
    expect(complaint("a: 1\n---\nb: 1\n", kRequest), "one YAML document");
}

/// Every prefix, and every line left out: each reads or is refused in words.
TEST(MoveIt, DamagedFilesAreRefusedInWords) {
    int refused = 0;
    for (std::size_t length = 0; length < kScene.size(); length += 11) {
        refused += complaint(kScene.substr(0, length), kRequest) != "none" ? 1 : 0;
    }
    EXPECT_GT(refused, 20);
    for (std::size_t at = 0; at < kScene.size(); at = kScene.find('\n', at) + 1) {
        const std::string cut = kScene.substr(0, at) + kScene.substr(kScene.find('\n', at) + 1);
        complaint(cut, kRequest);
    }
    for (std::size_t at = 0; at < kRequest.size(); at = kRequest.find('\n', at) + 1) {
        complaint(kScene, kRequest.substr(0, at) + kRequest.substr(kRequest.find('\n', at) + 1));
    }
}

}  // namespace
}  // namespace praxis::tamp
