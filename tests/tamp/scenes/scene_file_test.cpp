#include "tamp/scenes/scene_file.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "parser/diagnostic.hpp"
#include "tamp/geometry/extent.hpp"
#include "tamp/scenes/occupancy_map.hpp"

namespace praxis::tamp {
namespace {

namespace fs = std::filesystem;

const std::string kScene = R"(
robot:
  builtin: arm7
  base: {xyz: [0, 0, 0.5]}
  start: {arm: ready, gripper: open}
bodies:
  - name: table
    box: [1, 0.6, 0.04]
    pose: {xyz: [0.6, 0, 0.4], rpy: [0, 0, 1.5707963267948966]}
  - name: rack
    pose: {xyz: [-0.6, 0, 0.5], quaternion: [0, 0, 0, 1]}
    shapes:
      - box: [0.3, 0.3, 0.02]
      - cylinder: {radius: 0.1, length: 0.2}
        pose: {xyz: [0, 0, 0.11]}
  - name: can1
    object: Soup
    cylinder: {radius: 0.03, length: 0.12}
    movable: true
    color: [1, 0, 0.5]
    grasps: [side]
    on: table
    at: [0.1, -0.2]
    yaw: 0.3
  - name: cube
    box: [0.05, 0.05, 0.05]
    movable: true
    on: rack-top
  - name: held
    sphere: {radius: 0.02}
    movable: true
    attached: {link: hand, pose: {xyz: [0, 0, 0.2]}}
surfaces:
  - {name: table, body: table}
  - {name: rack-top, body: rack, shape: 1}
  - {name: floor, size: [4, 4]}
regions:
  - {name: goal, surface: table, center: [-0.3, 0.1], size: [0.2, 0.1]}
allowed_collisions:
  - [link0, table]
  - [link1, link4]
gravity: [0, 0, -1.62]
stream_options: {grasp_samples: 5}
)";

Scene read(const std::string& text) {
    return parse_scene({"scene.yaml", text});
}

std::string replaced(std::string text, const std::string& old, const std::string& with) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), with);
}

std::string complaint(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "none";
}

TEST(SceneFile, ReadsRobotBodiesAndNames) {
    const Scene scene = read(kScene);
    EXPECT_EQ(scene.robot->base.translation().z(), 0.5);
    EXPECT_EQ(scene.start.size(), scene.robot->dimension());
    EXPECT_NE(scene.start, scene.robot->zero());
    const World& world = *scene.world;
    ASSERT_EQ(world.size(), 5U);
    EXPECT_EQ(world[1].model->shapes.size(), 2U);
    EXPECT_EQ(world[2].model->color, (std::array<float, 3>{1, 0, 0.5}));
    EXPECT_TRUE(world[2].model->movable);
    EXPECT_FALSE(world[0].model->movable);
    EXPECT_EQ(scene.objects.at("soup"), 2);
    EXPECT_EQ(scene.objects.at("table"), 0);
    EXPECT_EQ(scene.grasps.at(2), std::vector<GraspKind>{GraspKind::side});
    EXPECT_FALSE(scene.grasps.contains(3));
    EXPECT_EQ(scene.gravity.z(), -1.62);
    EXPECT_EQ(scene.stream_options.at("grasp_samples"), "5");
    ASSERT_TRUE(world[4].attachment);
    EXPECT_EQ(world[4].attachment->link, scene.robot->find_link("hand"));
    EXPECT_EQ(world[4].attachment->touching, scene.robot->end_effectors[0].links);
    EXPECT_TRUE(world.allowed({Participant::Kind::link, 0}, {Participant::Kind::body, 0}));
    EXPECT_FALSE(scene.robot->may_collide(scene.robot->find_link("link1"), scene.robot->find_link("link4")));
}

/// The indented block at the top of docs/scene-format.md.
TEST(SceneFile, TheManualsExampleStartsWell) {
    std::ifstream manual(std::string(PRAXIS_SOURCE_DIR) + "/docs/scene-format.md");
    std::string example;
    for (std::string line; std::getline(manual, line);) {
        if (line.starts_with("    ")) example += line.substr(4) + '\n';
        if (line.starts_with("Whatever")) break;
    }
    const Scene scene = read(example);
    EXPECT_EQ(scene.world->size(), 2U);
    EXPECT_EQ(check_scene(scene), std::vector<std::string>{});
}

TEST(SceneFile, BodiesStandOnSurfaces) {
    const Scene scene = read(kScene);
    // The table is turned by a right angle: its surface's x axis is the world's y axis.
    const Pose& can = (*scene.world)[2].pose;
    EXPECT_LT((can.translation() - Vector3(0.6 + 0.2, 0.1, 0.42 + 0.06 + kPlacementGap)).norm(), 1e-9);
    EXPECT_NEAR(can.linear()(1, 0), std::sin(0.3 + 1.5707963267948966), 1e-9);
    const AxisBox cube = extent((*scene.world)[3].model->shapes, (*scene.world)[3].pose);
    EXPECT_NEAR(cube.lower.z(), 0.5 + 0.11 + 0.1 + kPlacementGap, 1e-9);
    EXPECT_EQ(scene.surfaces[0].size, (std::array<double, 2>{1, 0.6}));
    EXPECT_EQ(scene.surfaces[2].body, -1);
    EXPECT_EQ(scene.regions[0].surface, 0);
    EXPECT_EQ(scene.find_region("goal"), 0);
    EXPECT_EQ(scene.find_surface("goal"), -1);
}

TEST(SceneFile, TheStartIsCheckedByName) {
    const auto problems_of = [](const std::string& text) {
        std::string all;
        for (const std::string& problem : check_scene(read(text))) all += problem + '\n';
        return all;
    };
    EXPECT_EQ(problems_of(kScene), "");
    const std::string lifted = problems_of(replaced(kScene, "xyz: [0.6, 0, 0.4]", "xyz: [0.2, 0, 0.6]"));
    EXPECT_NE(lifted.find("link 'link1' touches body 'table'"), std::string::npos) << lifted;
    const std::string met = problems_of(replaced(kScene, "on: rack-top", "on: table\n    at: [0.1, -0.2]"));
    EXPECT_NE(met.find("body 'can1' touches body 'cube'"), std::string::npos) << met;
    EXPECT_EQ(met.find("body 'cube' touches"), std::string::npos) << met;  // told once
    const std::string far = problems_of(replaced(kScene, "start:", "joints: {joint1: 9}\n  start:"));
    EXPECT_NE(far.find("'joint1' is 9.0"), std::string::npos) << far;
}

TEST(SceneFile, ErrorsNamePlaceAndMend) {
    const auto expect = [](const std::string& old, const std::string& with, const std::string& words) {
        const std::string message = complaint(replaced(kScene, old, with));
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect("builtin: arm7", "builtin: arm8", "scene.yaml:3:12: error: there is no built-in robot 'arm8'");
    expect("arm: ready", "arm: reddy", "did you mean 'ready'?");
    expect("arm: ready", "arn: ready", "did you mean 'arm'?");
    expect("arm: ready", "arm: [1, 2]", "must have 7 numbers, not 2");
    expect("[1, 0.6, 0.04]", "[1, 0.6, -0.04]", "a size of a box must be above 0");
    expect("[1, 0.6, 0.04]", "[1, 0.6, .nan]", "must be a finite number, not '.nan'");
    expect("[1, 0.6, 0.04]", "[1, 0.6, 1e999]", "must be a finite number");
    expect("movable: true", "moveable: true", "did you mean 'movable'?");
    expect("- name: rack", "- name: table", "a body or a link of this name already");
    expect("- name: rack", "- name: hand", "a body or a link of this name already");
    expect("object: Soup", "object: TABLE", "stands for the object 'table', but so does 'table'");
    expect("color: [1, 0, 0.5]", "color: [255, 0, 0]", "from 0 to 1");
    expect("grasps: [side]", "grasps: [below]", "'top' and 'side'");
    expect("on: table", "on: tabel", "did you mean 'table'?");
    expect("on: rack-top", "pose: {xyz: [0, 0, 1]}\n    at: [0, 0]", "has at or yaw, but not on");
    expect("on: rack-top", "on: rack-top\n    pose: {}", "one of pose, on and attached only");
    expect("link: hand", "link: hnad", "did you mean 'hand'?");
    expect("shape: 1", "shape: 2", "the body has shapes 0 to 1");
    expect("body: rack,", "body: held,", "the body has shapes 0 to 0");
    expect("{name: floor, size: [4, 4]}", "{name: floor}", "surface 'floor' needs a size");
    expect("center: [-0.3, 0.1]", "center: [-0.45, 0.1]", "does not lie within surface 'table'");
    expect("[link0, table]", "[link0, tabel]", "did you mean 'table'?");
    expect("[link0, table]", "[link0]", "a pair of links or bodies");
    expect("[link0, table]", "[table, table]", "two different ones");
    expect("rpy: [0, 0, 1.5707963267948966]", "rpy: [0, 0, 0], quaternion: [0, 0, 0, 1]",
           "both rpy and quat");
    expect("sphere: {radius: 0.02}", "sphere: {radius: 0.02}\n    box: [1, 1, 1]", "has two shapes");
    expect("sphere: {radius: 0.02}", "mesh: gone.stl", "there is no file gone.stl");
    expect("gravity:", "gravity: 9\ngravity:", "twice");
    expect("robot:\n", "robots:\n", "did you mean 'robot'?");
}

TEST(SceneFile, DamagedFilesAreRefusedInWords) {
    for (std::size_t length = 0; length < kScene.size(); length += 23) complaint(kScene.substr(0, length));
    for (std::size_t at = 0; at + 1 < kScene.size(); at = kScene.find('\n', at) + 1) {
        complaint(kScene.substr(0, at) + kScene.substr(kScene.find('\n', at) + 1));
    }
    EXPECT_NE(complaint(std::string(100'000, '[')), "none");
    EXPECT_NE(complaint("robot: {builtin: " + std::string(100'000, '{')), "none");
    std::string nested = "a:\n  ";
    for (int i = 0; i < 100'000; ++i) nested += "- ";
    EXPECT_NE(complaint(nested), "none");
    EXPECT_NE(complaint("a:\n" + std::string(20'000, ' ') + std::string(20'000, '-')), "none");
}

class FilesBeside : public testing::Test {
  protected:
    FilesBeside() : folder_(fs::temp_directory_path() / ("praxis-scene-" + std::to_string(::getpid()))) {
        fs::create_directory(folder_);
    }
    ~FilesBeside() override { fs::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    Scene read_with(const std::string& shape) const {
        write("scene.yaml", "robot: {builtin: arm7}\nbodies:\n  - {name: thing, " + shape + "}\n");
        return read_scene((folder_ / "scene.yaml").string());
    }
    std::string complaint_about(const std::string& shape) const {
        try {
            read_with(shape);
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    }

    fs::path folder_;
};

TEST_F(FilesBeside, MeshesAndMapsAreRead) {
    write("plate.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    write("points.xyz", "# two points\n0.5 0.5 0.5\n1.0,0.5;0.5 7\n");
    const Scene plate = read_with("mesh: {file: plate.off, scale: 2}");
    EXPECT_NEAR(extent((*plate.world)[0].model->shapes).upper.x(), 2, 1e-6);
    const Scene cloud =
        read_with("points: {file: points.xyz, edge: 0.1, sensor: [0, 0.5, 0.5], unknown: free}");
    const auto& map = std::get<std::shared_ptr<const OccupancyMap>>((*cloud.world)[0].model->shapes[0].shape);
    EXPECT_EQ(map->count(Occupancy::occupied), 2U);
    EXPECT_FALSE(map->unknown_blocks());
    EXPECT_TRUE((*cloud.world)[0].model->balls.empty());
}

TEST_F(FilesBeside, WhatIsWrongWithThemIsTold) {
    write("points.xyz", "0.5 0.5 0.5\n1.0 zero 0.5\n");
    write("map.bt", "no map\n");
    const auto expect = [&](const std::string& shape, const std::string& words) {
        const std::string message = complaint_about(shape);
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect("points: points.xyz", "points.xyz:2: 'zero' is no number");
    expect("octomap: map.bt", "is no OctoMap file");
    expect("octomap: {file: map.bt, bounds: [[0, 0, 0], [0, 1, 1]]}", "the lower corner first");
    expect("octomap: {file: map.bt, unknown: maybe}", "'obstacle' or 'free'");
    expect("points: {file: points.xyz, least_points: 0.5}", "whole number");
    expect("mesh: map.bt", "cannot be used");
}

}  // namespace
}  // namespace praxis::tamp
