// An experiment as one self-contained page: curves and figures of every environment, and for some runs which
// skill was chosen in each cycle, and why.
//
// Nothing is loaded from elsewhere. A slider or the arrow keys go over the cycles of a run. The page stays
// small: of each method only some runs, of each run at most so many cycles, of each choice only the best
// candidates are in it, and it says how many were left out.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "practice/experiment/comparison.hpp"
#include "practice/experiment/results.hpp"

namespace praxis::practice {

struct ReportOptions {
    std::string title = "Practice";  ///< any text, as is `summary`
    std::string summary;             ///< a line below the title
    ComparisonOptions comparison;
    std::size_t runs_shown = 1;         ///< of each method in each environment, by smallest seed
    std::size_t cycles_shown = 100;     ///< of a run; of more, evenly spaced ones
    std::size_t candidates_shown = 10;  ///< of a choice: the best ones, and what was chosen
};

/// Throws std::invalid_argument as `compare_methods` does.
std::string report_page(std::span<const RunResult> runs, const ReportOptions& options);

}  // namespace praxis::practice
