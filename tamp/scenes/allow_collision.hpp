// Entries of allowed-collision lists.
#pragma once

#include <optional>
#include <string_view>

#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A link of the robot, or else a body of the world, by its name.
std::optional<Participant> find_participant(const Robot& robot, const World& world, std::string_view name);

/// The two are not checked against each other from now on: told to the robot if both are its links, else to
/// the world.
void allow_collision(Robot& robot, World& world, const Participant& first, const Participant& second);

}  // namespace praxis::tamp
