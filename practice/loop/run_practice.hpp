// A whole run of practice in a simulator: cycles, tests between them, and what is left of it.
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "practice/environment.hpp"
#include "practice/experiment/results.hpp"
#include "practice/loop/options.hpp"

namespace praxis::practice {

struct PracticeHooks {
    /// After each test (the first: before any practice).
    std::function<void(const RunResult&)> on_test;
    std::stop_token stop;
};

/// A whole run in a simulator: cycles, each followed by a test on `test_tasks` tasks that are the same for
/// all methods and cycles of a seed. With a journal the run is taken up where it was left. Stopped early, the
/// curve is shorter.
RunResult run_practice(const SimulatedEnvironment& environment, const PracticeOptions& options,
                       const PracticeHooks& hooks = {}, const std::string& journal = {});

}  // namespace praxis::practice
