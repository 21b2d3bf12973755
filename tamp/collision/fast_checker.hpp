// The fast checker: eight configurations at a time, on balls (`kernel.hpp`).
//
// The robot and what it holds are balls; bodies of the world and links that stand still are what they are.
// Where every moving link is made of spheres, the balls are the shapes, and the kernel decides alone: it says
// "free" only where the exact checker does, and "collision" wrongly only within a margin of some micrometres
// (`kernel_model.hpp`). Where balls cover other shapes there are three answers: free of the covering balls is
// free; a contact of balls inside of the shapes is a contact; what lies between, the exact checker is asked,
// which also finds the contacts among what the group does not move.
//
// Certified motions. The kernel can check that nothing is touched while every ball is grown by how far it can
// move within a stretch of the segment, given its speed in the middle and a bound on its acceleration; that
// proves the stretch free, between configurations too. Stretches that cannot be proved are halved, down to
// 2^-13 rad, where the configuration in the middle decides; with covering balls down to 1/128 rad, where the
// exact checker decides in the middle.
#pragma once

#include <memory>

#include "tamp/collision/checker.hpp"
#include "tamp/collision/fcl_checker.hpp"

namespace praxis::tamp {

/// A cache that checkers of changed worlds share makes them cheap: tens of microseconds. Throws
/// std::invalid_argument as `make_fcl_checker` does, for links or attached bodies with shapes and
/// without balls, and for groups of more than 16 variables. Its functions throw it for positions of another
/// length than the group's, not finite, or beyond 10 000 from 0.
std::unique_ptr<CollisionChecker> make_fast_checker(const CollisionProblem& problem,
                                                    std::shared_ptr<SolidCache> cache = nullptr);

}  // namespace praxis::tamp
