// How much practice a method needs to a given fraction of solved tasks.
//
// The answer for a run is the transitions of the first *evaluation* that reaches the threshold: nothing
// between two evaluations is assumed, so that the answer is never below the truth and at most one cycle above
// it. A run that never reaches it is *censored*: it needs more than the transitions it practised. Censored
// runs stay in every figure with what they practised, and are counted beside it; a mean with some of them is
// a lower bound of the true mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "practice/experiment/results.hpp"
#include "search/statistics.hpp"

namespace praxis::practice {

struct ThresholdOptions {
    double solved = 0.8;  ///< in [0, 1]
    bool stays = false;   ///< every later evaluation must reach it as well
};

struct Reached {
    std::int64_t transitions = 0;  ///< at the evaluation that reached it, or of the whole run if censored
    bool censored = false;
    bool operator==(const Reached&) const = default;
};

/// Throws std::invalid_argument for a curve without points or a threshold outside of [0, 1].
Reached transitions_to(std::span<const CurvePoint> curve, const ThresholdOptions& options);

/// Over the runs of a method.
struct ReachedSummary {
    IntervalEstimate mean;     ///< of transitions, censored runs with what they practised
    double median = 0;         ///< infinite if half of the runs or more are censored
    std::size_t censored = 0;  ///< of `mean.count` runs
};

/// Throws std::invalid_argument where there is no run.
ReachedSummary summarise_reached(std::span<const Reached> runs, double confidence = 0.95);

/// How many times the practice of `b` that `a` needs: the ratio of the means.
struct PracticeRatio {
    double value = 0;
    double low = 0, high = 0;  ///< percentile bootstrap over the runs of each
    std::size_t censored_a = 0, censored_b = 0;
};

/// What a ratio with censored runs can be said to be: "" if there are none; "at least" if only `a` has some
/// (its true mean is larger); "at most" if only `b` has; "unclear" if both have.
std::string bound_of(const PracticeRatio& ratio);

struct BootstrapOptions {
    double confidence = 0.95;
    int resamples = 10'000;
    std::uint64_t seed = 1;
};

/// The interval resamples the runs of `a` and of `b` independently (Efron 1979). 0 / 0 counts as 1, and
/// something / 0 is infinite. Throws std::invalid_argument where a method has no run or the options are odd.
PracticeRatio practice_ratio(std::span<const Reached> a, std::span<const Reached> b,
                             const BootstrapOptions& options = {});

}  // namespace praxis::practice
