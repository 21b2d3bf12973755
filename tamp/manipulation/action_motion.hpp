// What a skill does, and why it cannot be done.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tamp/motion/path.hpp"
#include "tamp/report/trajectory_document.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/scenes/world.hpp"

namespace praxis::tamp {

/// A motion of one group, or something that happens while nothing moves.
struct MotionPiece {
    TrajectoryDocument::Motion kind = TrajectoryDocument::Motion::transit;
    int group = 0;
    Path path = {};  ///< from where the group is; empty: stands still
    /// It leads from the home configuration or back to it: it may be left out where the action before or
    /// after can be joined directly.
    bool homing = false;
    /// What happens at its end: the body is taken, or let go at a pose in the world.
    std::optional<std::pair<int, Attachment>> attach = {};
    std::optional<std::pair<int, Pose>> detach = {};
};

/// What a skill does, from the home configuration and back to it: pieces one after the other, each
/// collision-free in the world as it then is.
struct ActionMotion {
    std::vector<MotionPiece> pieces = {};
};

/// Why a skill cannot be done.
struct ActionFailure {
    TrajectoryDocument::Reason reason = TrajectoryDocument::Reason::other;
    std::string message = {};
    /// Movable bodies: the skill fails as long as all of them stand where they stand. Empty: whatever stands.
    std::vector<int> bodies = {};
    bool each = false;  ///< each of them alone is enough
    /// False: it was not all tried that the discretisation allows; another try may succeed.
    bool definite = true;
    Configuration configuration = {};    ///< of the whole robot at the failure; empty: none
    std::vector<Contact> contacts = {};  ///< there
    WorldPointer world = {};             ///< in which that was
};

struct ActionResult {
    std::optional<ActionMotion> motion = {};
    ActionFailure failure = {};  ///< where there is no motion

    explicit operator bool() const { return motion.has_value(); }
};

}  // namespace praxis::tamp
