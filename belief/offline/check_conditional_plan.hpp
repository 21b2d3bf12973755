// The independent check of a conditional plan: it is executed in simulated worlds, and what was executed is
// checked on the lifted task as it is written.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "belief/belief_task.hpp"
#include "belief/offline/conditional_plan.hpp"
#include "belief/worlds.hpp"
#include "search/budget.hpp"

namespace praxis::belief {

struct ConditionalVerdict {
    bool valid = false;       ///< the goal is reached in every world that was looked at
    std::size_t checked = 0;  ///< worlds looked at; fewer than all if the budget ran out
    std::string reason;       ///< if invalid: the world and what fails there
};

ConditionalVerdict check_conditional_plan(const std::shared_ptr<const BeliefTask>& task,
                                          const ConditionalPlan& plan, std::span<const WorldState> worlds,
                                          const Budget& budget = {});

}  // namespace praxis::belief
