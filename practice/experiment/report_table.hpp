// The figures of one environment as a table of a page.
#pragma once

#include <string>

#include "practice/experiment/comparison.hpp"

namespace praxis::practice {

std::string report_table(const EnvironmentResult& result, const ComparisonOptions& options);

}  // namespace praxis::practice
