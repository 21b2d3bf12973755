// What `plan refine` gives out: the plan as text, the figures as JSON, the files.
#pragma once

#include <string>

#include "app/refine/refine_options.hpp"
#include "tamp/solve/solve.hpp"

namespace praxis::app {

/// One action a line with its time, then cost, duration and the values of the parameters, as comments.
std::string plan_text(const tamp::Solution& solution);
/// Why there is none, in words.
std::string failure_text(const tamp::Refinement& refinement);
/// For the report.
std::string refine_json(const tamp::Solution& solution);
/// Writes the files that were asked for. Throws OutputError. True: one went to standard output.
bool write_motion(const tamp::Solution& solution, const RefineCommandOptions& options);

}  // namespace praxis::app
