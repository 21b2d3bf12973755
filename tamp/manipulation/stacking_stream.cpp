#include "tamp/manipulation/stacking_stream.hpp"

#include <stdexcept>

#include "tamp/geometry/extent.hpp"

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
    const auto model = [scene](const Value& value) -> const BodyModel& {
        const auto found = scene->bodies.find(value.name());
        if (found == scene->bodies.end()) {
            throw std::invalid_argument("the scene has no body for '" + value.name() + "'");
        }
        return *scene->world[found->second].model;
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
