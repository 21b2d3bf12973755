// Learning curves as comma-separated values, for spreadsheets and plotting programs.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "parser/source.hpp"
#include "practice/experiment/curves.hpp"

namespace praxis::practice {

/// One row an evaluation: environment,method,seed,cycle,transitions,solved. `read_curves` gives back exactly
/// these curves. Checks the curves.
std::string curves_to_csv(std::span<const Curve> curves);

/// One row a point of a method's curve: environment,method,transitions,mean,low,high,n.
std::string summaries_to_csv(std::span<const CurveSummary> summaries);

/// Runs in the order of their first row; rows of several runs may be mixed. Throws InputError, with line and
/// mend, for anything that `curves_to_csv` would not write.
std::vector<Curve> read_curves(const Source& source);

}  // namespace praxis::practice
