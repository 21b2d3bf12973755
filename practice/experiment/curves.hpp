// Learning curves of runs, and of methods: the mean over the seeds at common numbers of transitions.
//
// Seeds are evaluated at different numbers of transitions, since a cycle may end early. Between evaluations a
// curve is a step: what an evaluation found holds until the next one. After its last evaluation a run
// practises no more, and solves what it solved then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "practice/experiment/results.hpp"
#include "search/statistics.hpp"

namespace praxis::practice {

/// The learning curve of one run.
struct Curve {
    std::string environment, method;
    std::uint64_t seed = 0;
    std::vector<CurvePoint> points;
    bool operator==(const Curve&) const = default;
};

std::vector<Curve> curves_of(std::span<const RunResult> runs);

/// Throws std::invalid_argument, naming the run, unless each has points, cycles rise, transitions do not
/// fall, fractions are in [0, 1], and no seed of a method occurs twice.
void check_curves(std::span<const Curve> curves);

/// The fraction solved after so many transitions; before the first point, that of the first.
double solved_at(std::span<const CurvePoint> points, std::int64_t transitions);

/// All transitions at which some curve has a point, sorted; more than `most` (at least 2) are replaced by
/// `most` evenly spaced ones from the first to the last.
std::vector<std::int64_t> common_grid(std::span<const Curve> curves, std::size_t most = 200);

struct SummaryPoint {
    std::int64_t transitions = 0;
    IntervalEstimate solved;  ///< over the seeds; Student's interval cut to [0, 1]
    bool operator==(const SummaryPoint&) const = default;
};

/// The learning curve of one method.
struct CurveSummary {
    std::string environment, method;
    std::vector<SummaryPoint> points;
};

/// Environments, and the methods of each, in the order of their first run. All methods of an environment
/// share a grid; each has the part of it between its first and its last evaluation, and these two. Checks the
/// curves.
std::vector<CurveSummary> summarise(std::span<const Curve> curves, double confidence = 0.95,
                                    std::size_t most = 200);

}  // namespace praxis::practice
