// The runs of `plan belief` as a table for people.
#pragma once

#include <span>
#include <string>

#include "app/report.hpp"

namespace praxis::app {

/// A line of sums and a line for each run without success; with `measures` also success, SPL and means with
/// their confidence intervals.
std::string belief_table(std::span<const BeliefRun> runs, bool measures);

/// What the run cost and what others would have spent in its world, as a comment for a plan.
std::string belief_comparison(const BeliefRun& run);

}  // namespace praxis::app
