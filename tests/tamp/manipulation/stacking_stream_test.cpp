#include "tamp/manipulation/stacking_stream.hpp"

#include <gtest/gtest.h>

#include "tamp/scenes/body.hpp"

namespace praxis::tamp {
namespace {

std::shared_ptr<const BodyModel> block(const std::string& name, double height) {
    return make_body(name, {{Pose::Identity(), Box{{0.05, 0.05, height}}}}, true);
}

TEST(Stacking, StandsOverTheMiddleTurnedAsTheLowerOne) {
    const Pose lower = pose_from_rpy({0.5, 0.2, 0.1}, {0, 0, 0.7});
    const auto pose = stacking_pose(*block("a", 0.06), *block("b", 0.1), lower);
    ASSERT_TRUE(pose);
    EXPECT_TRUE(pose->isApprox(pose_from_rpy({0.5, 0.2, 0.1 + 0.05 + 0.03 + kPlacementGap}, {0, 0, 0.7})));
}

TEST(Stacking, NothingStandsOnABlockThatLiesOnItsSide) {
    const Pose lower = pose_from_rpy({0.5, 0.2, 0.1}, {1.57, 0, 0});
    EXPECT_FALSE(stacking_pose(*block("a", 0.06), *block("b", 0.1), lower));
}

TEST(Stacking, AStreamGivesOnePoseOrNamesTheBodyThatIsMissing) {
    const auto scene = std::make_shared<PickPlaceScene>();
    scene->world =
        World().with_body(block("a", 0.06), Pose::Identity()).with_body(block("b", 0.1), Pose::Identity());
    scene->bodies = {{"a", 0}, {"b", 1}};
    StreamLibrary library;
    bind_stacking(library, scene);
    const StreamLibrary::BoundStream* stream = library.find("sample-stacking");
    ASSERT_NE(stream, nullptr);
    EXPECT_EQ(stream->info.max_samples, 1U);
    const Value pose = Value::of(pose_from_rpy({0, 0, 0.3}, Vector3::Zero()));
    std::vector<Value> inputs = {Value().named("a"), Value().named("b"), pose};
    const Budget budget;
    StreamCall call{
        .stream = "sample-stacking", .inputs = inputs, .fluents = {}, .random = Random(0), .budget = budget};
    const StreamResult result = stream->callback(call);
    ASSERT_EQ(result.kind, StreamResult::Kind::sample);
    EXPECT_NEAR(result.outputs.at(0).get<Pose>().translation().z(), 0.38 + kPlacementGap, 1e-12);
    inputs[0] = Value().named("c");
    EXPECT_THROW(stream->callback(call), std::invalid_argument);
}

}  // namespace
}  // namespace praxis::tamp
