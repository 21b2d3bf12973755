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

/// An estimate with its 95 % confidence interval.
struct Estimate {
    double value = 0;
    double low = 0, high = 0;
};

/// A rate of `count` trials: Wilson's score interval (1927). Of no trials: 0, in [0, 1].
Estimate rate(std::size_t successes, std::size_t count);

/// The mean of values, with Student's interval: mean -+ t s / sqrt(n). Of one value the interval is that
/// value; of none everything is 0.
Estimate mean(std::span<const double> values);

/// S * l / max(p, l); 1 where both lengths are 0. Throws std::invalid_argument for negative or infinite
/// lengths.
double success_weighted(bool success, double length, double best);

struct Measures {
    std::size_t runs = 0;
    Estimate success, false_success;
    /// Nothing unless all runs have the length that is needed.
    std::optional<Estimate> spl_info, spl_omni;
    /// Sum of p by the sum of the best policy's l over the runs that succeeded. Where several policies are
    /// equally good SPL_info is below 1 even for one of them, as another may be luckier in a world; this
    /// is 1.
    std::optional<double> length_ratio;
    Estimate length;             ///< over all runs
    Estimate successful_length;  ///< over those that succeeded
    Estimate plans, processor_seconds;
};

Measures measure(std::span<const MeasuredRun> runs);

/// A few lines for people.
std::string to_string(const Measures& measures);

}  // namespace praxis::belief
