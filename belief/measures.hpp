// What runs in sampled worlds are measured by.
//
// Success is judged on the world; a *false success* is a run that ended with the goal believed and not true.
// SPL
// ("success weighted by path length", Anderson et al. 2018) is the mean of S * l / max(p, l): p is the length
// of the run, l that of a best one. What "best" means is told apart here: *SPL_info* takes l as what the best
// contingent policy spends in that world (a policy that knows no more than the agent, so that 1 can be
// attained); *SPL_omni* takes the optimal plan from the true state, as if everything were known (an upper
// bound that no agent that has to look can attain).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "search/statistics.hpp"

namespace praxis::belief {

/// One run. Lengths and costs are of the same unit: actions, or their costs.
struct MeasuredRun {
    bool success = false;                     ///< the goal was believed, and holds in the world
    bool false_success = false;               ///< the goal was believed, and does not hold
    double length = 0;                        ///< p
    std::optional<double> policy_length;      ///< l of SPL_info in this world, where it was computed
    std::optional<double> omniscient_length;  ///< l of SPL_omni
    std::size_t plans = 0;
    double processor_seconds = 0;
};

/// S * l / max(p, l); 1 where both lengths are 0. Throws std::invalid_argument for negative or infinite
/// lengths.
double success_weighted(bool success, double length, double best);

/// Estimates with their 95 % intervals; of no runs all are 0.
struct Measures {
    std::size_t runs = 0;
    IntervalEstimate success, false_success;
    /// Nothing unless all runs have the length that is needed.
    std::optional<IntervalEstimate> spl_info, spl_omni;
    /// Sum of p by the sum of the best policy's l over the runs that succeeded. Where several policies are
    /// equally good SPL_info is below 1 even for one of them, as another may be luckier in a world; this
    /// is 1.
    std::optional<double> length_ratio;
    IntervalEstimate length;                            ///< over all runs
    std::optional<IntervalEstimate> successful_length;  ///< over those that succeeded, if any did
    IntervalEstimate plans, processor_seconds;
};

Measures measure(std::span<const MeasuredRun> runs);

/// A few lines for people.
std::string to_string(const Measures& measures);

}  // namespace praxis::belief
