// The figures of an experiment for people: a table an environment.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "practice/experiment/comparison.hpp"

namespace praxis::app {

/// `runs`: how many there are to be in all; where some are missing the text says so.
std::string practice_table(std::span<const practice::EnvironmentResult> results,
                           const practice::ThresholdOptions& threshold, std::size_t runs);

}  // namespace praxis::app
