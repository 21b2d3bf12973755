// Checks a trajectory document against the robot and the world that it is for, from nothing but these: it
// shares no code with the planner, the time parametrisation or the fast collision checker.
//
// Checked are: the document's robot and bodies are those of the world; segments follow each other in time,
// and each begins where the last one ended, with its velocity; positions, velocities and accelerations fit
// together and keep the limits; no collision, by FCL, at configurations at most `step` apart; what is
// attached stood where the hand takes it, what is let go is where the document says and stands on something,
// and the robot is at rest when that happens.
#pragma once

#include <optional>
#include <string>

#include "tamp/collision/checker.hpp"
#include "tamp/report/trajectory_document.hpp"
#include "tamp/sampling/area.hpp"

namespace praxis::tamp {

struct TrajectoryCheck {
    double step = kCheckStep / 4;   ///< largest distance of two checked configurations (radians, metres)
    double tolerance = 1e-5;        ///< of positions, velocities and poses
    double limit_tolerance = 1e-6;  ///< of limits, relative
    double drop = 0.01;             ///< metres that a body let go may fall before it meets something
    double grip = 0.01;  ///< metres between a hand and a body that it takes, at most (of balls around them)
    std::vector<Area> floors = {};  ///< in the world, not on bodies: what is let go may stand there, too
};

struct TrajectoryVerdict {
    bool valid = true;
    std::string reason = {};  ///< one sentence; empty if valid
    int segment = -1;         ///< where
    double time = 0;          ///< when
    std::size_t checked = 0;  ///< configurations that were checked for collisions
};

/// Throws std::invalid_argument if the document is not in order by itself (`check_document`).
TrajectoryVerdict validate_trajectory(const TrajectoryDocument& document, const Robot& robot,
                                      const World& world, const Configuration& start,
                                      const TrajectoryCheck& check = {});

}  // namespace praxis::tamp
