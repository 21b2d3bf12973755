// `plan belief --offline`: a conditional plan.
#pragma once

#include "app/command_line.hpp"
#include "app/run.hpp"
#include "belief/knowledge_planner.hpp"

namespace praxis::app {

/// Makes the plan and writes what was asked for.
Ending make_offline_plan(Run& run, const BeliefOptions& options, const belief::KnowledgePlanner& planner);

}  // namespace praxis::app
