// Motions in time, as a trajectory document.
#pragma once

#include <string>
#include <vector>

#include "tamp/manipulation/manipulator.hpp"
#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

struct ScheduleOptions {
    double max_deviation = 0.05;  ///< how far corners may be cut (`motion/time_parametrisation.hpp`)
    double speed = 1;             ///< share of the limits of velocity, in (0, 1]
    double acceleration = 1;      ///< and of acceleration
};

/// An action as PDDL names it, and what it does.
struct ScheduledAction {
    std::string name = {};
    std::vector<std::string> arguments = {};
    ActionMotion motion = {};
};

/// Robot, bodies, actions and segments, one piece after the other from the manipulator's home on. Corners are
/// cut only where the fast checker finds that free.
TrajectoryDocument schedule(const Manipulator& manipulator, const World& world,
                            const std::vector<ScheduledAction>& actions, const ScheduleOptions& options = {});

}  // namespace praxis::tamp
