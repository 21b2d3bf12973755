// Makes bodies.
#pragma once

#include <memory>
#include <string>

#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A body with its shapes covered by balls (`geometry/cover.hpp`), unless there is an occupancy map among
/// them. Throws std::invalid_argument if it has no name, or a shape cannot be.
std::shared_ptr<const BodyModel> make_body(std::string name, std::vector<PlacedShape> shapes,
                                           bool movable = false,
                                           const std::array<float, 3>& color = BodyModel().color);

}  // namespace praxis::tamp
