#include <gtest/gtest.h>

#include "parser/diagnostic.hpp"
#include "tamp/scenes/scene_file.hpp"

namespace praxis::tamp {
namespace {

Scene scene_with(const std::string& poses) {
    return parse_scene({"scene.yaml", "robot: {builtin: arm7}\nposes:\n" + poses});
}

TEST(ScenePoses, AreKnownByNameInSmallLetters) {
    const Scene scene = scene_with("  - {name: Slot1, pose: {xyz: [0.1, 0.2, 0.3], rpy: [0, 0, 1]}}\n");
    ASSERT_TRUE(scene.poses.contains("slot1"));
    EXPECT_TRUE(scene.poses.at("slot1").isApprox(pose_from_rpy({0.1, 0.2, 0.3}, {0, 0, 1})));
}

TEST(ScenePoses, NeedANameOfTheirOwnAndAPose) {
    const std::string pose = "  - {name: a, pose: {xyz: [0, 0, 0]}}\n";
    EXPECT_THROW(scene_with(pose + pose), InputError);
    EXPECT_THROW(scene_with("  - {name: a}\n"), InputError);
    EXPECT_THROW(scene_with("  - {name: a, pose: {xyz: [0, 0]}}\n"), InputError);
}

}  // namespace
}  // namespace praxis::tamp
