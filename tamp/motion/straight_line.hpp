// Straight motions of the tool, for approaching and retreating: from a configuration, the tool moves on the
// straight line to a target pose and turns evenly on the way.
//
// Small steps of inverse kinematics, each from the configuration before, so that the arm does not change its
// posture. Between two waypoints of the path the tool leaves the line by at most `deviation`: where it would
// by more, the step is halved. The line ends early where it cannot go on; the path up to there is good.
#pragma once

#include <cstdint>
#include <span>

#include "tamp/collision/checker.hpp"
#include "tamp/motion/inverse_kinematics.hpp"
#include "tamp/motion/path.hpp"

namespace praxis::tamp {

struct StraightLineOptions {
    double step = 0.02;                   ///< metres of the tool between waypoints
    double turning_step = 0.1;            ///< radians of the tool between waypoints
    double deviation = 1e-3;              ///< metres and radians off the line between waypoints
    double max_jump = 0.3;                ///< greatest change of a variable from waypoint to waypoint
    double position_tolerance = 1e-5;     ///< metres, at waypoints
    double rotation_tolerance = 1e-4;     ///< radians, at waypoints
    CollisionChecker* checker = nullptr;  ///< of the same group; none: collisions are not looked at
    double check_step = kCheckStep;
};

/// Why a line ended.
enum class LineEnd : std::uint8_t {
    arrived,
    kinematics,  ///< out of reach or of limits, or only by a jump
    collision,
};

struct StraightLine {
    LineEnd end = LineEnd::arrived;
    double fraction = 0;  ///< of the line: 1 if it arrived
    Path path = {};       ///< from the start to where the line ended
    /// Where the next waypoint would have been, if the line ended by a collision on the way to it.
    Configuration blocked = {};
};

/// Throws std::invalid_argument if `start` is not a configuration of the group within its limits, `target` is
/// not finite, or the options make no sense. A start in collision ends the line at once.
StraightLine straight_line(const InverseKinematics& ik, std::span<const double> start, const Pose& target,
                           const StraightLineOptions& options = {});

}  // namespace praxis::tamp
