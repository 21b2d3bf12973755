// The runs of `plan belief`: how the loop is set up, what a run came to, how the command ends.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/command_line.hpp"
#include "app/run.hpp"
#include "belief/agent.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::app {

belief::AgentOptions belief_agent_options(const BeliefOptions& options, std::size_t axioms);

/// What a run came to in its world, which was in the state `first` at its beginning: a success is judged by
/// executing what has truly happened on the task as it is written.
BeliefRun judge_belief_run(const belief::BeliefTask& task, const belief::WorldState& first,
                           const belief::SimulatedWorld& world, belief::RunStatus status);
/// Enters the searches for plans.
void set_searches(BeliefRun& run, std::span<const double> plan_seconds);

/// How the command ends. `worlds`: how many runs there should be.
Ending belief_ending(const Run& run, std::span<const BeliefRun> runs, std::size_t worlds);

}  // namespace praxis::app
