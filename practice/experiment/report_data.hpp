// The choices of some runs as the data of a report page.
#pragma once

#include <span>
#include <string>

#include "practice/experiment/report_page.hpp"
#include "practice/experiment/results.hpp"

namespace praxis::practice {

/// JSON that may stand inside of a `script` element: {"runs": [{"name", "cycles": count, "skills": [text],
/// "choices": [{"cycle", "transitions", "solved", "chosen", "left": count, "rows": [[skill, score,
/// competence, predicted, cost, tries, successes]]}]}], "left": count}. `skill` is a place in "skills";
/// numbers have four digits, and infinite ones are texts. "solved" is what the last evaluation before the
/// choice found.
std::string report_data(std::span<const RunResult> runs, const ReportOptions& options);

}  // namespace praxis::practice
