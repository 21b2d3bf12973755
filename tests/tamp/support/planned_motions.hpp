// The motions of a solved problem's plan, as they come from the streams: from home to home.
#pragma once

#include <vector>

#include "tamp/manipulation/action_motion.hpp"
#include "tamp/solve/schedule.hpp"
#include "tests/tamp/support/solved_problem.hpp"

namespace praxis::tamp {

struct PlannedMotions {
    const SceneProblem& problem;
    BoundScene bound;
    std::vector<ScheduledAction> actions = {};

    explicit PlannedMotions(const SolvedProblem& solved)
        : problem(solved.problem),
          bound(bind_scene(problem.task, problem.scene, scene_options(problem.scene))) {
        for (const RefinedStep& step : solved.plan().steps) {
            ScheduledAction& action = actions.emplace_back();
            action.name = step.name;
            for (const Value& argument : step.arguments) {
                action.arguments.push_back(argument.name());
                if (const ActionMotion* motion = argument.get_if<ActionMotion>()) action.motion = *motion;
            }
        }
    }

    std::vector<ActionMotion> motions() const {
        std::vector<ActionMotion> result;
        for (const ScheduledAction& action : actions) result.push_back(action.motion);
        return result;
    }

    TrajectoryDocument schedule(const ScheduleOptions& options = {}) const {
        return tamp::schedule(*bound.manipulator, *problem.scene.world, actions, options);
    }

    /// Empty: collision-free, within the limits, and whatever else the validator looks at.
    std::string fault(const TrajectoryDocument& document) const {
        return validate_trajectory(document, *problem.scene.robot, *problem.scene.world, problem.scene.start)
            .reason;
    }
};

}  // namespace praxis::tamp
