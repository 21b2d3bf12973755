#include "tamp/manipulation/pick_place_streams.hpp"

#include <gtest/gtest.h>

#include "parser/files.hpp"
#include "tamp/refine/refine.hpp"
#include "tamp/robots/builtin.hpp"
#include "tamp/scenes/body.hpp"

namespace praxis::tamp {
namespace {

Pose at(double x, double y, double z) {
    return pose_from_rpy({x, y, z}, Vector3::Zero());
}

/// A table with sticks, one region on the left and one on the right, and a problem about them.
struct Table {
    PickPlaceScene scene;
    std::map<std::string, Value, std::less<>> values;
    std::string sticks, poses, initial;

    Table() {
        scene.world =
            World().with_body(make_body("table", {{Pose::Identity(), Box{{0.8, 1.4, 0.1}}}}), at(0.6, 0, 0));
        scene.areas["left"] = {.name = "left", .body = 0, .pose = at(-0.1, 0.35, 0.05), .size = {0.3, 0.3}};
        scene.areas["right"] = {
            .name = "right", .body = 0, .pose = at(-0.1, -0.35, 0.05), .size = {0.3, 0.3}};
    }

    void add(double x, double y) {
        const int number = static_cast<int>(scene.world.size());
        const std::string name = "stick" + std::to_string(number);
        const Pose pose = at(x, y, 0.15 + kPlacementGap);
        scene.world =
            scene.world.with_body(make_body(name, {{Pose::Identity(), Box{{0.04, 0.04, 0.2}}}}, true), pose);
        scene.bodies[name] = number;
        values["p" + std::to_string(number)] = Value::of(pose);
        sticks += " " + name;
        poses += " p" + std::to_string(number);
        initial += "(graspable " + name + ") (placeable " + name + " left) (placeable " + name +
                   " right) (pose-of " + name + " p" + std::to_string(number) + ") (at " + name + " p" +
                   std::to_string(number) + ") ";
    }

    Refinement solve(const std::string& goal, const RefineOptions& options = {}) const {
        const auto robot = std::make_shared<const Robot>(builtin_robot("arm7"));
        Configuration home = robot->zero();
        for (const NamedState& state : robot->states) {
            if (state.name == "ready") {
                robot->insert(robot->groups[static_cast<std::size_t>(robot->find_group(state.group))],
                              state.positions, home);
            }
        }
        StreamLibrary library;
        bind_pick_place(library, std::make_shared<const PickPlaceScene>(scene),
                        std::make_shared<const Manipulator>(robot, home));
        const std::string folder = PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/";
        const Source problem{"problem", "(define (problem table) (:domain pick-place) (:objects" + sticks +
                                            " - body" + poses +
                                            " - pose left right - region) (:init (hand-empty) " + initial +
                                            ") (:goal " + goal + "))"};
        const StreamTask task =
            parse_streams(read_source(folder + "domain.pddl"), problem, read_source(folder + "streams.pddl"))
                .task;
        return refine({.task = &task, .library = &library, .values = values, .options = options});
    }
};

std::string text(const RefinedPlan& plan) {
    std::string lines;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) lines += plan.action(i) + "\n";
    return lines;
}

TEST(PickPlace, CarriesAStickToTheOtherSide) {
    Table table;
    table.add(0.5, 0.3);
    const Refinement found = table.solve("(in stick1 right)");
    ASSERT_EQ(found.status, RefineStatus::solved) << (found.reasons.empty() ? "" : found.reasons[0]);
    ASSERT_EQ(found.plan->steps.size(), 2U) << text(*found.plan);
    EXPECT_EQ(found.plan->steps[0].name, "pick");
    const Pose& pose = found.plan->steps[1].arguments[1].get<Pose>();
    EXPECT_TRUE(
        stands_in(*table.scene.world[1].model, pose, table.scene.world, table.scene.areas.at("right")));
}

TEST(PickPlace, ManySticksFindPlacesBesideEachOther) {
    Table table;
    std::string goal = "(and";
    for (int i = 0; i < 5; ++i) {
        table.add(0.4 + 0.08 * i, 0.3);
        goal += " (in stick" + std::to_string(i + 1) + " right)";
    }
    const Refinement found = table.solve(goal + ")");
    ASSERT_EQ(found.status, RefineStatus::solved) << (found.reasons.empty() ? "" : found.reasons[0]);
    EXPECT_EQ(found.plan->steps.size(), 10U) << text(*found.plan);
}

TEST(PickPlace, WhatStandsInTheWayIsMovedFirst) {
    Table table;
    // Stick 1 stands in a box that is open to the robot's side only; stick 2 in its opening.
    const double half = 0.13;
    auto wall = [&](const std::string& name, const Box& box, const Pose& pose) {
        table.scene.world = table.scene.world.with_body(make_body(name, {{Pose::Identity(), box}}), pose);
    };
    wall("back", Box{{0.02, 2 * half + 0.04, 0.3}}, at(0.72, 0, 0.2 + kPlacementGap));
    wall("side1", Box{{0.3, 0.02, 0.3}}, at(0.58, half + 0.01, 0.2 + kPlacementGap));
    wall("side2", Box{{0.3, 0.02, 0.3}}, at(0.58, -half - 0.01, 0.2 + kPlacementGap));
    wall("roof", Box{{0.34, 2 * half + 0.04, 0.02}}, at(0.58, 0, 0.37 + kPlacementGap));
    const int first = static_cast<int>(table.scene.world.size());
    table.add(0.62, 0);
    table.add(0.48, 0);
    const std::string target = "stick" + std::to_string(first);
    const Refinement found = table.solve("(in " + target + " right)");
    ASSERT_EQ(found.status, RefineStatus::solved) << (found.reasons.empty() ? "" : found.reasons[0]);
    ASSERT_EQ(found.plan->steps.size(), 4U) << text(*found.plan);
    EXPECT_EQ(found.plan->steps[0].arguments[0].name(), "stick" + std::to_string(first + 1));
    EXPECT_EQ(found.plan->steps[2].arguments[0].name(), target);
    EXPECT_GT(found.statistics.nogoods + found.statistics.soft_nogoods, 0U);
}

TEST(PickPlace, OutOfReachIsInfeasibleAndSaysWhy) {
    Table table;
    table.add(1.5, 0.3);
    const Refinement found = table.solve("(in stick1 right)");
    EXPECT_EQ(found.status, RefineStatus::infeasible);
    ASSERT_FALSE(found.reasons.empty());
    EXPECT_NE(found.reasons[0].find("stick1"), std::string::npos) << found.reasons[0];
}

}  // namespace
}  // namespace praxis::tamp
