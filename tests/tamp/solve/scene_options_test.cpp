#include "tamp/solve/scene_options.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "parser/diagnostic.hpp"
#include "tamp/robots/builtin.hpp"

namespace praxis::tamp {
namespace {

Scene scene_of(const std::string& robot) {
    Scene scene;
    scene.robot = std::make_shared<const Robot>(builtin_robot(robot));
    return scene;
}

SceneOptions read(const std::string& name, const std::string& value, const std::string& robot = "arm7") {
    Scene scene = scene_of(robot);
    scene.stream_options[name] = value;
    return scene_options(scene);
}

void refused(const std::string& name, const std::string& value, const std::string& part,
             const std::string& robot = "arm7") {
    try {
        read(name, value, robot);
        ADD_FAILURE() << name << ": " << value << " was accepted";
    } catch (const InputError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("'" + name + "'"), std::string::npos) << text;
        EXPECT_NE(text.find(part), std::string::npos) << text;
    }
}

TEST(SceneOptionsOf, DefaultsAreThoseOfTheParts) {
    const SceneOptions options = scene_options(scene_of("arm7"));
    EXPECT_EQ(options.effector, "");
    EXPECT_EQ(options.base, "");
    EXPECT_EQ(options.manipulator.approach, ManipulatorOptions().approach);
    EXPECT_EQ(options.grasps.turns, GraspOptions().turns);
    EXPECT_EQ(options.placements.count, PlacementOptions().count);
}

TEST(SceneOptionsOf, ARobotWithABaseDrivesUnlessItIsToldToStand) {
    EXPECT_EQ(scene_options(scene_of("mobile-arm7")).base, "base");
    EXPECT_EQ(read("base", "none", "mobile-arm7").base, "");
    EXPECT_EQ(read("base", "base", "mobile-arm7").base, "base");
}

TEST(SceneOptionsOf, EachSetsItsOwnNumber) {
    struct Numbered {
        const char* name;
        const char* value;
        std::function<double(const SceneOptions&)> get;
    };
    const std::vector<Numbered> all = {
        {"approach", "0.6", [](const SceneOptions& o) { return o.manipulator.approach; }},
        {"lift", "0.6", [](const SceneOptions& o) { return o.manipulator.lift; }},
        {"arm_configurations", "17", [](const SceneOptions& o) { return o.manipulator.arm_configurations; }},
        {"base_poses", "17", [](const SceneOptions& o) { return o.manipulator.base_poses; }},
        {"base_nearest", "0.6", [](const SceneOptions& o) { return o.manipulator.base_nearest; }},
        {"base_furthest", "0.6", [](const SceneOptions& o) { return o.manipulator.base_furthest; }},
        {"plan_time", "0.6", [](const SceneOptions& o) { return o.manipulator.plan_time; }},
        {"grasp_turns", "17", [](const SceneOptions& o) { return o.grasps.turns; }},
        {"grasp_places", "17", [](const SceneOptions& o) { return o.grasps.places; }},
        {"grasp_depth", "0.6", [](const SceneOptions& o) { return o.grasps.depth; }},
        {"grasp_clearance", "0.6", [](const SceneOptions& o) { return o.grasps.clearance; }},
        {"placements", "17", [](const SceneOptions& o) { return o.placements.count; }},
        {"placement_margin", "0.6", [](const SceneOptions& o) { return o.placements.margin; }},
    };
    const SceneOptions defaults = scene_options(scene_of("arm7"));
    for (const Numbered& option : all) {
        const SceneOptions changed = read(option.name, option.value);
        for (const Numbered& other : all) {
            const double wanted = other.name == option.name ? std::stod(option.value) : other.get(defaults);
            EXPECT_EQ(other.get(changed), wanted) << option.name << " and " << other.name;
        }
        for (const char* wrong : {"", "much", "-1", "nan", "inf", "1e9", "3 m", "0.1.2"})
            refused(option.name, wrong, std::string("not '") + wrong + "'");
    }
}

TEST(SceneOptionsOf, LengthsMayBeFractionsAndNothing) {
    EXPECT_EQ(read("lift", "0.025").manipulator.lift, 0.025);
    EXPECT_EQ(read("lift", "0").manipulator.lift, 0);
    refused("lift", "101", "from 0 to 100");
}

TEST(SceneOptionsOf, CountsAreWholeAndAboveZero) {
    refused("placements", "0", "a whole number, 1 or more");
    refused("placements", "1.5", "a whole number, 1 or more");
    refused("placements", "100001", "from 0 to 100000");
    EXPECT_EQ(read("placements", "100000").placements.count, 100'000U);
}

TEST(SceneOptionsOf, TheBaseMustBeFurtherThanNear) {
    Scene scene = scene_of("mobile-arm7");
    scene.stream_options["base_nearest"] = "0.9";
    EXPECT_THROW(scene_options(scene), InputError);
    scene.stream_options["base_furthest"] = "0.9";
    EXPECT_NO_THROW(scene_options(scene));
}

TEST(SceneOptionsOf, NamesAreThoseOfTheRobot) {
    EXPECT_EQ(read("effector", "hand").effector, "hand");
    refused("effector", "nose", "not 'nose'");
    refused("effector", "", "the name of an end effector");
    EXPECT_EQ(read("base", "arm").base, "arm");
    refused("base", "wheels", "or none, not 'wheels'");
    refused("base", "base", "a group of robot", "arm7");
}

TEST(SceneOptionsOf, UnknownNamesAreRefusedWithASuggestion) {
    refused("placement", "3", "did you mean 'placements'");
    refused("aproach", "0.1", "did you mean 'approach'");
    refused("colour", "red", "docs/tamp.md");
}

}  // namespace
}  // namespace praxis::tamp
