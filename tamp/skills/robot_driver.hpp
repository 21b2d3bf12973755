// What refined skills need of a robot: its positions, a place to send set-points to, a gripper, a clock.
//
// A robot's program implements this over its own controllers; `SimulatedDriver` does without a robot.
#pragma once

#include <map>
#include <string>

#include "search/skills.hpp"
#include "tamp/geometry/pose.hpp"
#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Where the robot is to be at the end of a control period, and how fast; one number a variable of the whole
/// robot. A gripper with a controller of its own passes over the numbers of its fingers.
struct RobotCommand {
    Configuration positions;
    Configuration velocities;
};

/// Poses of bodies in the world, by their names.
using BodyPoses = std::map<std::string, Pose>;

/// Orders are answered by how they ended: anything but `done` ends the skill with that message.
class RobotDriver {
  public:
    virtual ~RobotDriver() = default;

    /// Of the whole robot, as measured now.
    virtual Configuration positions() = 0;
    /// Bodies that are seen now. Those that are not seen are taken to be where the plan has them.
    virtual BodyPoses bodies() { return {}; }

    virtual Execution command(const RobotCommand& command) = 0;
    /// Closes the hand on the body, which should then be in the hand as the plan has it. Returns when the
    /// hand has closed; failed: it does not hold the body.
    virtual Execution grasp(const TrajectoryDocument::Hold& hold) = 0;
    /// Opens the hand; the body should then stand as the plan has it.
    virtual Execution release(const TrajectoryDocument::Stand& stand) = 0;
    /// Opens the hand after a grasp that failed.
    virtual void open() = 0;

    /// A clock that never goes back.
    virtual double seconds() = 0;
    virtual void wait_until(double seconds) = 0;
};

}  // namespace praxis::tamp
