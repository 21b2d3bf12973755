// All that the course of a run depends on, as a text: journals and stored runs are refused where it differs.
#pragma once

#include <string>

#include "practice/environment.hpp"
#include "practice/loop/options.hpp"

namespace praxis::practice {

/// The environment with a digest of its description, and the options by name; numbers as they read back
/// exactly. Neither the number of cycles nor of threads is in it: more cycles go on with the same run.
std::string settings_text(const Environment& environment, const PracticeOptions& options);

}  // namespace praxis::practice
