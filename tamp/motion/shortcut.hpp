// Shorter paths by straight cuts.
#pragma once

#include <cstdint>

#include "search/budget.hpp"
#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

struct ShortcutOptions {
    std::uint64_t seed = 0;
    double step = kCheckStep;
    int tries = 64;     ///< cuts between random places
    int patience = 16;  ///< tries in vain, one after another, that end it
    Budget budget = {};
};

/// The path with detours cut off: first from every waypoint to the farthest one that it sees, then between
/// random places of the path (Geraerts, Overmars 2007). Ends stay; every edge that is new is free at `step`.
void shortcut(CollisionChecker& checker, Path& path, const ShortcutOptions& options = {});

}  // namespace praxis::tamp
