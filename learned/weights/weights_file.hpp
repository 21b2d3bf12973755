// The weights of a trained planner in a file, with all that is needed to build it and to see that it works.
//
// The header holds the options of the planner, what the caller says about its origin (the command and the
// seed that made it, say), and the policy on a small built-in map. After reading, the planner must give this
// policy again: a file that would be interpreted in another way than when it was written is refused rather
// than believed.
#pragma once

#include <memory>
#include <string>

#include "learned/models/planner.hpp"
#include "learned/weights/array_file.hpp"

namespace praxis::learned {

/// InputError if it cannot be written.
void write_planner(const std::string& file, const Planner<float>& planner, const nlohmann::json& origin);

struct ReadPlanner {
    std::unique_ptr<Planner<float>> planner;
    nlohmann::json origin;
};

/// InputError that says what is wrong: see read_array_file; options that are out of range or that do not
/// agree with the number of weights; weights that are not finite; a self-test that fails.
ReadPlanner read_planner(const std::string& file);
ReadPlanner parse_planner(const ArrayFile& contents, const std::string& file);

/// What write_planner writes.
ArrayFile planner_contents(const Planner<float>& planner, const nlohmann::json& origin);

}  // namespace praxis::learned
