// `plan belief` where objects have to be found: `:hidden-objects`.
#pragma once

#include <memory>

#include "app/command_line.hpp"
#include "app/run.hpp"

namespace praxis::app {

/// Acts in one world after the other with the objects that are not hidden, and with those found on the way.
/// The world has all of them. Throws std::invalid_argument for options that do not go with it.
Ending explore_belief_task(Run& run, const BeliefOptions& options,
                           const std::shared_ptr<const ContingentTask>& full);

}  // namespace praxis::app
