// One descent of inverse kinematics: from a start to a configuration whose tool is at the target, or not.
//
// Damped least squares (Levenberg-Marquardt, damping after the error: Sugihara 2011) on the error of pose;
// limits are kept by projection: a variable at its limit that the step would push outwards is left out of the
// step and the others are solved for again. The redundancy that is left may pull towards a posture.
#pragma once

#include <array>
#include <cstdint>

#include "tamp/motion/kinematic_chain.hpp"

namespace praxis::tamp {

/// What of the target pose counts.
enum class IkTask : std::uint8_t {
    pose,               ///< position and orientation
    position,           ///< position of the tool's origin
    position_and_axis,  ///< position, and the direction of the tool's z axis
};

using Columns = std::array<double, kMaxColumns>;

struct IkDescent {
    const KinematicChain& chain;
    Frame target;
    IkTask task = IkTask::pose;
    double position_tolerance = 1e-5;
    double rotation_tolerance = 1e-4;
    Columns lower = {};
    Columns upper = {};
    const double* posture = nullptr;  ///< positions to stay near, as far as the task allows; may be null
    int iterations = 40;
};

struct IkDescentResult {
    bool converged = false;
    int iterations = 0;
    double position_error = 0;  ///< metres
    double rotation_error = 0;  ///< radians; 0 where the task has none
};

/// Starts from `positions` (within the limits) and leaves there what it found.
IkDescentResult descend(const IkDescent& problem, Columns& positions);

/// Distance of a frame to the target, by the task.
IkDescentResult measure(const IkDescent& problem, const Frame& frame);

}  // namespace praxis::tamp
