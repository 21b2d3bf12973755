// Collision checks of one group of a robot in one snapshot of the world.
//
// A checker fixes a robot, a world, a group and the positions of all other variables; it answers for
// positions of the group. Checked are: links against bodies, links against links, attached bodies against
// bodies and links; minus what the robot and the world allow, and minus pairs that the group cannot change
// (they are checked once, by `fixed_contacts`). Touching counts as a collision.
//
// Two backends: the exact one (`fcl_checker.hpp`: FCL on the shapes) and the fast one (`fast_checker.hpp`:
// eight configurations at a time on balls, and the exact one for what balls cannot decide). The fast one
// never says "free" where the exact one says "collision". A checker keeps scratch memory: it belongs to one
// thread.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// What a checker is made for.
struct CollisionProblem {
    std::shared_ptr<const Robot> robot;
    WorldPointer world;
    int group = 0;
    Configuration rest;  ///< of the whole robot; positions of variables outside of the group count
};

/// How finely motions are checked: two neighbouring checked configurations are at most `step` apart, in the
/// Euclidean norm over the group's variables (radians and metres). The published figures use 1/32.
inline constexpr double kCheckStep = 1.0 / 32;

class CollisionChecker {
  public:
    virtual ~CollisionChecker() = default;
    virtual const CollisionProblem& problem() const = 0;
    std::size_t dimension() const {
        return problem().robot->groups[static_cast<std::size_t>(problem().group)].variables.size();
    }

    /// No contact at these positions of the group. Limits are not looked at.
    virtual bool is_free(std::span<const double> positions) = 0;
    /// No contact on the straight segment, checked at `step`; both ends included.
    virtual bool is_motion_free(std::span<const double> from, std::span<const double> to,
                                double step = kCheckStep) = 0;
    /// As `is_motion_free` where `from` is known to be free, so that it need not be looked at again.
    virtual bool is_extension_free(std::span<const double> from, std::span<const double> to,
                                   double step = kCheckStep) {
        return is_motion_free(from, to, step);
    }
    /// No contact on the straight segment at a quarter of `kCheckStep`, or, where the backend can, anywhere
    /// on it.
    virtual bool is_motion_certified(std::span<const double> from, std::span<const double> to) {
        return is_motion_free(from, to, kCheckStep / 4);
    }
    /// Who touches at these positions: appends to `contacts` every pair, without repeating one.
    virtual void find_contacts(std::span<const double> positions, std::vector<Contact>& contacts) = 0;
    /// Contacts among what the group does not move: then every position of it is in collision.
    virtual const std::vector<Contact>& fixed_contacts() const = 0;
};

}  // namespace praxis::tamp
