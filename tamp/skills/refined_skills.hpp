// Executes refined skills on a robot: the last step from a plan to motion.
//
//     Solution solution = solve(problem);
//     RefinedSkills skills(planned(solution.document), *problem.scene.robot, driver);
//     Execution pick = skills.execute({{"pick", "can"}}, {}, stop);
//
// A call is a name and parameters; a `SkillRefiner` has the motions for it. Those of a finished plan are one
// kind of it (`planned`); another makes the motion when it is called, for the parameters that a learner
// proposes and for where things are by then.
//
// `illegal`: there is no such motion, or none that can start here (`RefinedSkill::refusal`); the robot has
// not moved. `failed`: the driver says so; the robot is off its path by more than the tolerance; or somebody
// asks to stop. The robot is then brought to rest along its path, within its limits of acceleration (unless
// it was the driver that refused a command). Where the first thing that the gripper does fails, the robot
// opens the hand if it was to take something, and goes back to where it began: the skill can be tried again.
#pragma once

#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "search/skills.hpp"
#include "tamp/robots/robot.hpp"
#include "tamp/skills/refined_skill.hpp"

namespace praxis::tamp {

/// Where the robot is, and the bodies that are seen.
struct Situation {
    Configuration positions;
    BodyPoses bodies;
};

/// The motions that a call may mean, the best one first. The first that the action names (`RefinedSkill::is`)
/// and that can start here is executed.
using SkillRefiner = std::function<std::vector<RefinedSkill>(
    const ActionName& action, std::span<const double> parameters, const Situation& situation)>;

/// The steps of a plan, whose parameters are chosen: it has nothing for others. Throws std::invalid_argument
/// as `RefinedSkill` does.
SkillRefiner planned(TrajectoryDocument document);

struct SkillExecution {
    double period = 0.004;  ///< seconds from command to command
    /// Of the robot and the bodies when a skill starts.
    SkillTolerance start = {};
    /// Of a variable while it moves, radians or metres.
    double tracking = 0.05;
};

class RefinedSkills : public Skills {
  public:
    /// Refers to the driver. Throws std::invalid_argument for options that are not positive.
    RefinedSkills(SkillRefiner refiner, const Robot& robot, RobotDriver& driver,
                  const SkillExecution& options = {});

    /// What the refiner throws is passed on; so is std::invalid_argument where robot, driver and motion have
    /// not the same variables.
    Execution execute(const ActionName& action, std::span<const double> parameters,
                      std::stop_token stop) override;

  private:
    SkillRefiner refiner_;
    std::vector<double> accelerations_;
    RobotDriver* driver_;
    SkillExecution options_;
};

}  // namespace praxis::tamp
