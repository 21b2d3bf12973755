// The stream `sample-stacking` (domains/tamp/blocks), bound to a scene: inputs a body, another one, and the
// pose at which that stands; output the pose of the first upon the second. There is one: over the middle of
// the lower one's top, turned as that is. The top must be level.
#pragma once

#include <memory>

#include "tamp/manipulation/pick_place_streams.hpp"

namespace praxis::tamp {

/// A body that the scene does not know is a StreamError when it is used.
void bind_stacking(StreamLibrary& library, std::shared_ptr<const PickPlaceScene> scene);

/// Where `upper` stands upon `lower` at `pose`; nothing where that lies on its side.
std::optional<Pose> stacking_pose(const BodyModel& upper, const BodyModel& lower, const Pose& pose);

}  // namespace praxis::tamp
