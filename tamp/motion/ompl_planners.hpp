// The planners of OMPL by name. Only for the files that call OMPL.
#pragma once

#include <ompl/base/Planner.h>

#include <string_view>

namespace praxis::tamp {

/// Throws std::invalid_argument for unknown names. `range` 0: the planner's default.
ompl::base::PlannerPtr make_ompl_planner(std::string_view name,
                                         const ompl::base::SpaceInformationPtr& information, double range);
/// Throws as `make_ompl_planner` does.
void check_ompl_planner_name(std::string_view name);

}  // namespace praxis::tamp
