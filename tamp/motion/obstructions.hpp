// Who is in the way of motions.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "tamp/motion/planner.hpp"

namespace praxis::tamp {

/// Looks at motions (pairs of ends) that the checker refuses and counts who is touched where each first
/// collides; most frequent first. What stands still counts; the robot's own links only where they touch each
/// other.
std::vector<Obstruction> find_obstructions(CollisionChecker& checker,
                                           std::span<const std::pair<Configuration, Configuration>> blocked,
                                           double step);

}  // namespace praxis::tamp
