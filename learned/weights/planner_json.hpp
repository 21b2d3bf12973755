// Planner options as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "learned/models/planner_options.hpp"

namespace praxis::learned {

nlohmann::json to_json(const PlannerOptions& options);
/// std::invalid_argument if a member is missing, unknown or of another type. Ranges are make_planner's to
/// check.
PlannerOptions planner_options(const nlohmann::json& json);

}  // namespace praxis::learned
