// RRT-Connect (Kuffner, LaValle 2000): a tree from the start and a tree from the goals grow towards samples
// and towards each other. With balanced trees and dynamic domains (Yershova et al. 2005): nodes that could
// not be extended are only tried again for samples near them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/budget.hpp"
#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

struct RrtConnectOptions {
    std::uint64_t seed = 0;
    double step = kCheckStep;  ///< of checks of motions
    double range = 1;          ///< longest edge
    int max_iterations = 100000;
    Budget budget = {};
};

struct RrtConnectResult {
    Path path = {};  ///< empty: none found
    int goal = -1;   ///< which goal the path ends at
    int iterations = 0;
    int nodes = 0;
    /// Some of the extensions that failed: pairs of ends.
    std::vector<std::pair<Configuration, Configuration>> blocked = {};
};

/// A path from `start` to one of `goals`, which must be free and of the group's dimension. Waypoints of
/// variables that are continuous run on without jumps: the last may differ from the goal by whole turns.
RrtConnectResult rrt_connect(CollisionChecker& checker, std::span<const double> start,
                             std::span<const Configuration> goals, const RrtConnectOptions& options = {});

}  // namespace praxis::tamp
