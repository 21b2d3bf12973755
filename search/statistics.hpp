// What a few random runs say: estimates with confidence intervals, and paired comparisons.
//
// A run (a seed, a sampled world) is the unit of independence: intervals of means are Student's over the
// runs. A Wilson interval is for proportions whose trials are independent, such as how many of the runs
// reached something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace praxis {

/// A value with its confidence interval.
struct IntervalEstimate {
    double value = 0;
    double low = 0, high = 0;
    std::size_t count = 0;  ///< of independent observations
    bool operator==(const IntervalEstimate&) const = default;
};

/// The quantile of Student's distribution: P(T <= t) = probability. `probability` in (0, 1), `degrees` > 0.
double student_quantile(double probability, double degrees);

/// The mean with Student's interval. One value says nothing about the spread: its interval is unbounded.
/// Throws std::invalid_argument where there is no value, one is not finite, or `confidence` is not in (0, 1).
IntervalEstimate mean_estimate(std::span<const double> values, double confidence = 0.95);

/// `mean_estimate` of fractions: the interval is cut to [0, 1].
IntervalEstimate fraction_estimate(std::span<const double> fractions, double confidence = 0.95);

/// The interval of Wilson (1927) for a proportion; inside of [0, 1] and never empty, also for 0 and 1.
/// Throws std::invalid_argument unless 0 <= successes <= trials and trials > 0.
IntervalEstimate proportion_estimate(std::int64_t successes, std::int64_t trials, double confidence = 0.95);

/// Two methods on the same seeds.
struct PairedComparison {
    IntervalEstimate difference;  ///< mean of a - b, with Student's interval over the pairs
    double probability = 1;  ///< two-sided, of a difference this large if there were none (paired t-test)
    std::size_t wins = 0;    ///< pairs with a > b
    std::size_t losses = 0;  ///< pairs with a < b
    std::size_t ties = 0;
};

/// Pairs a[i] with b[i]. Throws std::invalid_argument where the lengths differ, and as `mean_estimate` does.
PairedComparison compare_paired(std::span<const double> a, std::span<const double> b,
                                double confidence = 0.95);

}  // namespace praxis
