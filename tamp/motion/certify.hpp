// Paths whose every edge is certified.
//
// Checks at a step of 1/32 rad let some collisions slip through between the configurations that are looked
// at: some percent of the paths of the usual benchmarks. A certified path has passed
// `CollisionChecker::is_motion_certified` on every edge, which the fast checker proves for whole stretches.
#pragma once

#include <cstdint>

#include "search/budget.hpp"
#include "tamp/collision/checker.hpp"
#include "tamp/motion/path.hpp"
#include "tamp/motion/rrt_connect.hpp"

namespace praxis::tamp {

/// The edge (by its first waypoint) that is not certified; -1 if all are.
int find_uncertified(CollisionChecker& checker, const Path& path);

struct CertifyOptions {
    std::uint64_t seed = 0;
    Budget budget = {};
};

/// Certifies every edge; one that fails is replaced by a certified motion between its ends, found by
/// RRT-Connect. False if none is found for some edge; `path` is then as it was.
bool certify(CollisionChecker& checker, Path& path, const CertifyOptions& options = {});

/// RRT-Connect that takes only certified edges: slower, for where repairs fail.
RrtConnectResult certified_rrt_connect(CollisionChecker& checker, std::span<const double> start,
                                       std::span<const Configuration> goals,
                                       const RrtConnectOptions& options = {});

}  // namespace praxis::tamp
