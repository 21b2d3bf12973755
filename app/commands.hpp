// The commands. Each returns the exit code.
#pragma once

#include "app/command_line.hpp"

namespace praxis::app {

int run_plan(const PlanOptions& options);
int run_validate(const ValidateOptions& options);
int run_ground(const GroundCommandOptions& options);
int run_belief(const BeliefOptions& options);
int run_practice_command(const PracticeCommandOptions& options);
int run_list(const ListOptions& options);

}  // namespace praxis::app
