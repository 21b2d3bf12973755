// The figures of an experiment for programs.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "practice/experiment/comparison.hpp"

namespace praxis::app {

/// JSON as docs/command.md describes it; what is not finite is null. `runs`: how many there are to be in all.
std::string practice_json(std::span<const practice::EnvironmentResult> results,
                          const practice::ThresholdOptions& threshold, std::size_t runs);

}  // namespace praxis::app
