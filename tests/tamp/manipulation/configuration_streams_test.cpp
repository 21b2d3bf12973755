#include "tamp/manipulation/configuration_streams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/scenes/body.hpp"
#include "tamp/solve/solve.hpp"

namespace praxis::tamp {
namespace {

Pose at(double x, double y, double z) {
    return pose_from_rpy({x, y, z}, Vector3::Zero());
}

/// The arm before a table with two cans; streams are called by name.
struct Cans {
    explicit Cans(const char* robot_name = "arm7") {
        const auto robot = std::make_shared<const Robot>(builtin_robot(robot_name));
        Configuration home = robot->zero();
        for (const NamedState& state : robot->states)
            if (state.name == "ready" && state.group == "arm")
                robot->insert(robot->groups[static_cast<std::size_t>(robot->find_group("arm"))],
                              state.positions, home);
        const bool drives = robot->find_group("base") >= 0;
        manipulator = std::make_shared<const Manipulator>(robot, home, "", drives ? "base" : "");
        const auto can = [](const char* name) {
            return make_body(name, {{Pose::Identity(), Cylinder{0.03, 0.12}}}, true);
        };
        const auto scene = std::make_shared<PickPlaceScene>();
        scene->world = World()
                           .with_body(make_body("table", {{Pose::Identity(), Box{{0.6, 1.2, 0.1}}}}),
                                      at(drives ? 1.6 : 0.6, 0, 0.05))
                           .with_body(can("can1"), pose1)
                           .with_body(can("can2"), pose2);
        scene->bodies = {{"can1", 1}, {"can2", 2}};
        bind_pick_place(library, scene, manipulator);
        bind_configurations(library, scene, manipulator);
    }

    StreamResult call(const std::string& name, std::vector<Value> inputs,
                      const std::vector<FluentAtom>& fluents = {}, std::uint32_t attempt = 0) const {
        const Budget budget;
        StreamCall request{name, inputs, attempt, fluents, Random(1), budget};
        return library.find(name)->callback(request);
    }

    /// The first grasp of can1 that the arm has a configuration for, and that.
    std::pair<Value, Value> reachable_grasp(const Pose& pose) const {
        for (std::uint32_t i = 0;; ++i) {
            const StreamResult grasp = call("sample-grasp", {can1}, {}, i);
            if (grasp.kind != StreamResult::Kind::sample) break;
            const StreamResult found = call("inverse-kinematics", {can1, Value::of(pose), grasp.outputs[0]});
            if (found.kind == StreamResult::Kind::sample) return {grasp.outputs[0], found.outputs[0]};
        }
        ADD_FAILURE() << "no grasp is reachable";
        return {};
    }

    const Pose pose1 = at(0.55, 0.3, 0.1605);
    const Pose pose2 = at(0.55, -0.3, 0.1605);
    const Value can1 = Value().named("can1");
    const Value can2 = Value().named("can2");
    std::shared_ptr<const Manipulator> manipulator;
    StreamLibrary library;
};

TEST(ConfigurationStreams, TheHandStandsBeforeTheBodyAndGoesStraightToIt) {
    const Cans cans;
    const auto [grasp, before] = cans.reachable_grasp(cans.pose1);
    const Robot& robot = cans.manipulator->robot();
    const EndEffector& hand = cans.manipulator->effector();
    const Pose target = cans.pose1 * grasp.get<Grasp>().body_in_tool.inverse();
    const Pose tool = link_pose(robot, before.get<Configuration>(), hand.link) * hand.tool;
    const Vector3 way = target.translation() - tool.translation();
    EXPECT_NEAR(way.norm(), 0.1, 1e-4);
    EXPECT_NEAR(way.normalized().dot(target.linear().col(2)), 1, 1e-4);

    const Value pose = Value::of(cans.pose1);
    const std::vector<Value> place = {cans.can1, pose};
    const StreamResult taken = cans.call("plan-grasp", {cans.can1, pose, grasp, before}, {{"at", place}});
    ASSERT_EQ(taken.kind, StreamResult::Kind::sample);
    const auto& pieces = taken.outputs[0].get<ActionMotion>().pieces;
    EXPECT_EQ(pieces.front().path.front(), pieces.back().path.back());
    EXPECT_EQ(std::ranges::count_if(pieces, [](const MotionPiece& p) { return p.attach.has_value(); }), 1);
    EXPECT_GT(motion_length(taken.outputs[0].get<ActionMotion>()), 0.1);
}

TEST(ConfigurationStreams, WhatStandsInTheWayIsBlamed) {
    const Cans cans;
    const auto [grasp, before] = cans.reachable_grasp(cans.pose1);
    const Value pose = Value::of(cans.pose1);
    const Value beside = Value::of(at(0.55, 0.3, 0.29));  // on top, and in the way of a hand from above
    const std::vector<Value> first = {cans.can1, pose};
    const std::vector<Value> second = {cans.can2, beside};
    const StreamResult taken =
        cans.call("plan-grasp", {cans.can1, pose, grasp, before}, {{"at", first}, {"at", second}});
    ASSERT_NE(taken.kind, StreamResult::Kind::sample);
    EXPECT_EQ(taken.blame.reason, Reason::collision);
    EXPECT_EQ(taken.blame.fluents, std::vector<std::uint32_t>{1});
    EXPECT_TRUE(taken.blame.definite);
}

TEST(ConfigurationStreams, MotionsLeadFromOneConfigurationToTheOther) {
    const Cans cans;
    const auto [grasp, before] = cans.reachable_grasp(cans.pose1);
    const Value home = Value::of(cans.manipulator->model().home);
    const StreamResult free = cans.call("plan-free-motion", {home, before});
    ASSERT_EQ(free.kind, StreamResult::Kind::sample);
    const auto& piece = free.outputs[0].get<ActionMotion>().pieces.front();
    const Robot& robot = cans.manipulator->robot();
    const Group& arm = robot.groups[static_cast<std::size_t>(piece.group)];
    EXPECT_EQ(piece.path.front(), robot.extract(arm, home.get<Configuration>()));
    EXPECT_EQ(piece.path.back(), robot.extract(arm, before.get<Configuration>()));
    const StreamResult holding = cans.call("plan-holding-motion", {before, home, cans.can1, grasp});
    ASSERT_EQ(holding.kind, StreamResult::Kind::sample);
    EXPECT_EQ(holding.outputs[0].get<ActionMotion>().pieces.front().kind,
              TrajectoryDocument::Motion::transfer);
}

TEST(ConfigurationStreams, BodiesAtPosesAreClearOrNot) {
    const Cans cans;
    const auto clear = [&](const Pose& first, const Pose& second) {
        return cans.call("test-clear", {cans.can1, Value::of(first), cans.can2, Value::of(second)}).kind ==
               StreamResult::Kind::sample;
    };
    EXPECT_TRUE(clear(cans.pose1, cans.pose2));
    EXPECT_FALSE(clear(cans.pose1, at(0.57, 0.3, 0.1605)));
}

TEST(ConfigurationStreams, ABaseComesNearTheBodyAndTheArmReachesItFromThere) {
    const Cans cans("mobile-arm7");
    const Pose pose = at(1.4, 0, 0.1605);
    const Robot& robot = cans.manipulator->robot();
    const Group& base = robot.groups[static_cast<std::size_t>(robot.find_group("base"))];
    bool reached = false;
    int samples = 0;
    for (std::uint32_t i = 0; i < 64 && !reached; ++i) {
        const StreamResult stands = cans.call("sample-base", {cans.can1, Value::of(pose)}, {}, i);
        if (stands.kind == StreamResult::Kind::exhaustion) break;
        if (stands.kind != StreamResult::Kind::sample) continue;
        ++samples;
        const Configuration at_base = robot.extract(base, stands.outputs[0].get<Configuration>());
        const double away = std::hypot(at_base[0] - 1.4, at_base[1]);
        EXPECT_GT(away, 0.3);
        EXPECT_LT(away, 0.8);
        for (std::uint32_t g = 0; g < 18 && !reached; ++g) {
            const StreamResult grasp = cans.call("sample-grasp", {cans.can1}, {}, g);
            if (grasp.kind != StreamResult::Kind::sample) break;
            const StreamResult arm = cans.call(
                "inverse-kinematics-at", {cans.can1, Value::of(pose), grasp.outputs[0], stands.outputs[0]});
            if (arm.kind != StreamResult::Kind::sample) continue;
            EXPECT_EQ(robot.extract(base, arm.outputs[0].get<Configuration>()), at_base);
            reached = true;
        }
    }
    EXPECT_GT(samples, 0);
    EXPECT_TRUE(reached);
}

TEST(ConfigurationStreams, AnArmThatStandsHasNoBase) {
    const Cans cans;
    EXPECT_THROW(cans.call("sample-base", {cans.can1, Value::of(cans.pose1)}), std::invalid_argument);
    EXPECT_THROW(cans.call("test-clear",
                           {Value().named("cup"), Value::of(cans.pose1), cans.can2, Value::of(cans.pose2)}),
                 std::invalid_argument);
}

TEST(ConfigurationStreams, TwoCansChangePlacesAtTheCostOfTheirMotions) {
    const std::string domain = PRAXIS_SOURCE_DIR "/domains/tamp/configurations/domain.pddl";
    const std::string folder = PRAXIS_SOURCE_DIR "/problems/tamp/configurations/swap/";
    const SceneProblem problem =
        load_scene_problem(domain, folder + "problem.pddl", "", folder + "scene.yaml");
    const Solution solution = solve(problem, {}, Budget().limit_wall_time(60));
    ASSERT_EQ(solution.refinement.status, RefineStatus::solved);
    const RefinedPlan& plan = *solution.refinement.plan;
    double length = 0;
    for (const RefinedStep& step : plan.steps)
        length += motion_length(step.arguments.back().get<ActionMotion>());
    EXPECT_NEAR(plan.cost, length, 1e-6);
    EXPECT_GT(solution.checked, 100U);
}

}  // namespace
}  // namespace praxis::tamp
