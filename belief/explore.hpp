// The loop for a robot whose task grows: plans with the objects known so far, and with those found from then
// on.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "belief/agent.hpp"
#include "belief/robot.hpp"

namespace praxis::belief {

struct Exploration {
    RunStatus status = RunStatus::not_found;
    std::string message;
    std::vector<ActionName> actions;   ///< executed, in order
    std::vector<std::string> found;    ///< objects, in the order in which they were found
    std::vector<double> plan_seconds;  ///< processor seconds of the searches for each plan
    std::size_t groundings = 0;
    std::shared_ptr<const ContingentTask> task;  ///< as it stands at the end
};

/// Acts until the goal over the objects that are then known is known to hold, or something ends the run.
/// `watch` is told of every event, with the belief of that time, which is about the task of that time. What
/// the observer throws ends the run as an exception.
Exploration explore(std::shared_ptr<const ContingentTask> full, Skills& skills, Observer& observer,
                    const AgentOptions& options = default_agent_options(), const Budget& budget = {},
                    const std::function<void(const Event&, const Belief&)>& watch = {},
                    const CompilationOptions& compilation = {});

}  // namespace praxis::belief
