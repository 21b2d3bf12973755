// What a conditional plan costs, world by world.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/offline/conditional_plan.hpp"
#include "belief/worlds.hpp"

namespace praxis::belief {

/// Costs are in the task's units; 1 an action where there is no metric.
struct PlanCosts {
    std::vector<double> costs;  ///< by world
    double mean = 0;
    double worst = 0;
    double mean_actions = 0;
};

/// Executes the plan in each world, by the ground task. Nothing if it fails in one: an action is not
/// possible, there is no edge for what is answered, or the goal does not hold at the end.
std::optional<PlanCosts> plan_costs(const std::shared_ptr<const BeliefTask>& task,
                                    const ConditionalPlan& plan, std::span<const WorldState> worlds);

}  // namespace praxis::belief
