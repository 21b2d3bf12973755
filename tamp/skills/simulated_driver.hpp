// A robot that moves as it is told, nearly: for tests, examples and rehearsals.
//
// There are no forces: positions are those commanded, plus noise; bodies that are held move with the link
// that holds them, others stay where they are put. Time is only counted.
#pragma once

#include <cstdint>

#include "search/engines/random.hpp"
#include "tamp/skills/robot_driver.hpp"

namespace praxis::tamp {

struct SimulationOptions {
    double noise = 0;     ///< positions are off by up to this, radians or metres
    double slip = 0;      ///< probability that the hand closes on nothing
    double reach = 0.02;  ///< metres that a body may be off when the hand closes on it
    std::uint64_t seed = 0;
};

class SimulatedDriver : public RobotDriver {
  public:
    /// The robot and the bodies as at time 0 of the document; its plan does not matter. Throws
    /// std::invalid_argument as `check_document` does, and for options out of range.
    explicit SimulatedDriver(TrajectoryDocument scene, const SimulationOptions& options = {});

    Configuration positions() override;
    /// All movable bodies, exactly.
    BodyPoses bodies() override;
    Execution command(const RobotCommand& command) override;
    Execution grasp(const TrajectoryDocument::Hold& hold) override;
    Execution release(const TrajectoryDocument::Stand& stand) override;
    void open() override {}
    double seconds() override { return seconds_; }
    void wait_until(double seconds) override;

    /// Somebody puts a body there, out of the hand if need be. Throws std::invalid_argument for other names.
    void put(const std::string& body, const Pose& pose);
    /// Somebody puts the robot there.
    void put_robot(Configuration positions);
    bool holds(const std::string& body) const { return holds_.contains(body); }

  private:
    Pose pose_of(const std::string& body) const;
    double chance();

    TrajectoryDocument scene_;
    SimulationOptions options_;
    Random random_;
    Configuration positions_;
    BodyPoses stands_;                                       ///< of bodies that are not held
    std::map<std::string, TrajectoryDocument::Hold> holds_;  ///< by body
    double seconds_ = 0;
};

}  // namespace praxis::tamp
