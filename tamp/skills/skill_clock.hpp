// Time along a skill: it runs with the clock, is braked to a stop, or runs back.
//
// Whatever happens, the robot stays on the path that was planned and checked; only how fast it goes along it
// changes. With s the time along the skill and r = ds/dt its rate, velocities are r v(s) and accelerations
// r' v(s) + r^2 a(s): braking takes, in every period, the smallest rate that keeps these within the limits.
// That never fails, for keeping the rate keeps them.
#pragma once

#include <vector>

#include "tamp/skills/refined_skill.hpp"

namespace praxis::tamp {

class SkillClock {
  public:
    /// A command, and the seconds that the robot has for it.
    struct Step {
        RobotCommand command;
        double seconds = 0;
    };

    /// At the start, at rest. Refers to the skill. `accelerations`: the limits, one a variable; throws
    /// std::invalid_argument if they are not as many.
    SkillClock(const RefinedSkill& skill, std::vector<double> accelerations, double period);

    double time() const { return time_; }
    bool at_rest() const { return rate_ == 0; }

    /// A period on towards a time at which the skill rests, forwards or back; there it is at rest.
    Step run(double target);
    /// A period of braking, but not beyond `target`.
    Step brake(double target);

  private:
    bool within_limits(const RobotCommand& now, const RobotCommand& next, double rate) const;
    Step arrive(double target, double seconds);
    RobotCommand at(double time, double rate) const;

    const RefinedSkill* skill_;
    std::vector<double> accelerations_;
    double period_;
    double time_ = 0;
    double rate_ = 0;  ///< seconds along the skill a second; negative: back
};

}  // namespace praxis::tamp
