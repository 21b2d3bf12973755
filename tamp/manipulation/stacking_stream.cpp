#include "tamp/manipulation/stacking_stream.hpp"

#include "tamp/geometry/extent.hpp"
#include "tamp/manipulation/scene_lookup.hpp"

namespace praxis::tamp {

std::optional<Pose> stacking_pose(const BodyModel& upper, const BodyModel& lower, const Pose& pose) {
    constexpr double kLevel = 1 - 1e-6;
    if (pose.linear()(2, 2) < kLevel) return std::nullopt;
    const AxisBox below = extent(lower.shapes);
    const AxisBox above = extent(upper.shapes);
    const Vector3 shift(below.center().x() - above.center().x(), below.center().y() - above.center().y(),
                        below.upper.z() - above.lower.z() + kPlacementGap);
    return pose * Eigen::Translation3d(shift);
}

void bind_stacking(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene) {
    const SceneLookup lookup(std::move(scene));
    const auto model = [lookup](const Value& value) -> const BodyModel& {
        return *lookup.scene().world[lookup.body(value)].model;
    };
    const auto stack = [model](StreamCall& call) {
        const std::optional<Pose> pose =
            stacking_pose(model(call.inputs[0]), model(call.inputs[1]), call.inputs[2].get<Pose>());
        if (pose) return StreamResult::sample({Value::of(*pose)});
        return StreamResult::exhausted({.message = "'" + call.inputs[1].name() + "' has no level top for '" +
                                                   call.inputs[0].name() + "'"});
    };
    library.bind("sample-stacking", stack, {.effort = 1, .max_samples = 1});
}

}  // namespace praxis::tamp
