// Scenes that suit their task, and those that do not.
#include "tamp/solve/bind_scene.hpp"

#include <gtest/gtest.h>

#include "parser/files.hpp"
#include "tamp/scenes/scene_file.hpp"

namespace praxis::tamp {
namespace {

constexpr const char* kScene = R"(
robot: {builtin: arm7, start: {arm: ready, gripper: open}}
bodies:
  - {name: table, box: [0.5, 0.8, 0.1], pose: {xyz: [0.6, 0, 0.1]}}
  - {name: can1, box: [0.04, 0.04, 0.1], movable: true, on: table, at: [0, -0.1]}
  - {name: can2, box: [0.04, 0.04, 0.1], movable: true, on: table, at: [0, 0.1], object: Tin}
surfaces:
  - {name: table, body: table}
poses:
  - {name: middle, pose: {xyz: [0.6, 0, 0.2005]}}
)";

class BindScene : public testing::Test {
  protected:
    BoundScene bind() const {
        const std::string folder = PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/";
        const Source problem{
            "problem.pddl",
            "(define (problem p) (:domain pick-place) (:objects can1 tin can11 - body p1 p2 middle - "
            "pose table - region) (:init (hand-empty) " +
                initial + ") (:goal (in can1 table)))"};
        const StreamTask task =
            parse_streams(read_source(folder + "domain.pddl"), problem, read_source(folder + "streams.pddl"))
                .task;
        return bind_scene(task, scene, options);
    }

    void refused(const std::string& part) const {
        try {
            bind();
            ADD_FAILURE() << "bound, for '" << part << "'";
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
                << error.what() << " for '" << part << "'";
        }
    }

    const EndEffector& hand() const { return scene.robot->end_effectors.front(); }

    Scene scene = parse_scene({"scene.yaml", kScene});
    SceneOptions options = scene_options(scene);
    std::string initial = "(at can1 p1) (at tin p2)";
};

TEST_F(BindScene, GivesPosesTheirValues) {
    const BoundScene bound = bind();
    ASSERT_EQ(bound.values.size(), 3U);
    EXPECT_TRUE(bound.values.at("p1").get<Pose>().isApprox((*scene.world)[1].pose, 1e-15));
    EXPECT_TRUE(bound.values.at("p2").get<Pose>().isApprox((*scene.world)[2].pose, 1e-15));
    EXPECT_EQ(bound.values.at("middle").get<Pose>().translation().z(), 0.2005);
}

TEST_F(BindScene, BindsTheStreamsThatComeWithPraxis) {
    const BoundScene bound = bind();
    for (const char* name : {"sample-grasp", "sample-placement", "plan-pick", "plan-place"})
        EXPECT_NE(bound.library.find(name), nullptr) << name;
    ASSERT_NE(bound.manipulator, nullptr);
    EXPECT_EQ(bound.manipulator->effector().name, "hand");
}

TEST_F(BindScene, RefusesBodiesThatTheSceneDoesNotHave) {
    initial = "(at can11 p1)";
    refused("(at can11 p1): the scene has no body for 'can11'; did you mean 'can1'");
}

TEST_F(BindScene, RefusesOnePoseForTwoBodies) {
    initial = "(at can1 p1) (at tin p1)";
    refused("'p1' is another pose than that at which");
}

TEST_F(BindScene, RefusesABodyThatStandsElsewhereThanItsPose) {
    initial = "(at can1 middle)";
    refused("'middle' is another pose than that at which 'can1' stands in the scene");
}

TEST_F(BindScene, ABodyMayStandAtAPoseThatTheSceneNames) {
    scene.poses["p1"] = (*scene.world)[1].pose;
    EXPECT_NO_THROW(bind());
}

TEST_F(BindScene, RefusesAHandThatHoldsSomething) {
    scene.world = std::make_shared<const World>(scene.world->with_attached(
        1, {.link = hand().link, .in_link = hand().tool, .touching = hand().links}));
    refused("body 'can1' is held at the start");
}

TEST_F(BindScene, RefusesClosedFingers) {
    const Group& gripper =
        scene.robot->groups[static_cast<std::size_t>(scene.robot->find_group(hand().gripper))];
    scene.robot->insert(gripper, *hand().closed, scene.start);
    refused("the fingers are not open at the start: variable 'left_finger_joint' is 0.0");
}

TEST_F(BindScene, RefusesAStartInCollision) {
    Pose inside = Pose::Identity();
    inside.translation() = Vector3(0, 0, 0.3);
    scene.world = std::make_shared<const World>(scene.world->with_pose(1, inside));
    refused("the scene cannot start so:\n  ");
    refused("'can1'");
}

TEST_F(BindScene, RefusesAStartOutOfLimits) {
    scene.start[1] = 4;
    refused("the scene cannot start so:\n  ");
}

TEST_F(BindScene, RefusesHandsThatTheRobotDoesNotHave) {
    options.effector = "nose";
    refused("nose");
}

}  // namespace
}  // namespace praxis::tamp
