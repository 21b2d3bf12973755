// The figures that methods are compared by: solved at the end, practice to a threshold, time.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "practice/experiment/results.hpp"
#include "practice/experiment/threshold.hpp"
#include "search/statistics.hpp"

namespace praxis::practice {

struct ComparisonOptions {
    double confidence = 0.95;
    ThresholdOptions threshold;
    int evaluation_tasks = 0;  ///< tasks of an evaluation; 0: not known, and nothing is pooled
    std::string reference;     ///< the method that others are compared with; "": the first of an environment
};

/// A method beside the reference in the same environment.
struct AgainstReference {
    std::optional<PairedComparison>
        solved;              ///< at the end, over the seeds that both have; none: no such seed
    PracticeRatio practice;  ///< this method's transitions to the threshold / the reference's
};

struct MethodResult {
    std::string method;
    IntervalEstimate solved;  ///< at the end, over the runs
    /// The same over all tasks of all runs, as if they were independent.
    std::optional<IntervalEstimate> pooled;
    ReachedSummary reached;
    IntervalEstimate processor_seconds;       ///< of a run's practice and learning
    IntervalEstimate evaluation_seconds;      ///< of a run's evaluations
    std::optional<AgainstReference> against;  ///< none for the reference
};

struct EnvironmentResult {
    std::string environment;
    std::string reference;  ///< empty where no run of it is in this environment
    std::vector<MethodResult> methods;
};

/// Environments and methods in the order of their first run. Throws std::invalid_argument for curves that
/// `check_curves` refuses or odd options.
std::vector<EnvironmentResult> compare_methods(std::span<const RunResult> runs,
                                               const ComparisonOptions& options);

}  // namespace praxis::practice
