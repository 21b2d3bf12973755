// The exact checker: FCL (Pan, Chitta, Manocha 2012) on the shapes themselves.
//
// It is the reference that the fast checker and finished trajectories are held against, and what decides
// where covers by balls cannot. A state costs some microseconds: most pairs are told apart by balls and boxes
// around them, and links whose relative pose the group cannot change are never compared.
#pragma once

#include <memory>

#include "tamp/collision/checker.hpp"

namespace praxis::tamp {

class SolidCache;

/// Keeps what meshes and maps were prepared into. Give one to checkers of related worlds, on any threads.
std::shared_ptr<SolidCache> make_solid_cache();

/// A body that is attached may touch the links that its attachment names and the link that carries it. Links
/// that the world allows to touch each other are not checked. Throws std::invalid_argument if the problem has
/// no robot or world, its group or an attachment's link is not there, `rest` has another length than the
/// robot's configurations or is not finite, or a shape cannot be (a size that is not above 0).
///
/// The checker throws std::invalid_argument for positions of another length than the group's, or not finite.
std::unique_ptr<CollisionChecker> make_fcl_checker(const CollisionProblem& problem,
                                                   std::shared_ptr<SolidCache> cache = nullptr);

}  // namespace praxis::tamp
