// The loop of practice: task time, free time, learning; again and again, and nothing is reset in between but
// by the world itself.
//
// A cycle: the world gives a task; the robot pursues its goal until it holds or the horizon is spent (task
// time); then the method chooses what to practise until the cycle's skills are used up (free time); then the
// parameter policies are learned from all outcomes so far.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "practice/experiment/results.hpp"
#include "practice/loop/journal.hpp"
#include "practice/loop/learner.hpp"
#include "practice/methods/method.hpp"

namespace praxis::practice {

class PracticeLoop {
  public:
    /// `environment` and `world` must outlive this. Throws std::invalid_argument for wrong options.
    PracticeLoop(const Environment& environment, World& world, const PracticeOptions& options);

    /// One cycle; it ends early where nothing can be executed any more. False: it was stopped, or nothing
    /// could be executed at all. `on_learned` is called each time the policies have been learned.
    bool run_cycle(std::stop_token stop = {}, const std::function<void()>& on_learned = {});

    const Learner& learner() const { return learner_; }
    Method& method() { return *method_; }
    /// Whether the robot, by its present skills, solves a task in the simulator within the horizon. Learns
    /// nothing.
    bool solves(const SimulatedEnvironment& environment, const PracticeTask& task, Random& random);

  private:
    void step(const Decision& decision, const std::function<void()>& on_learned);
    void learn(const std::function<void()>& on_learned);
    int cycle_steps() const;

    World* world_;
    Learner learner_;
    std::unique_ptr<Method> method_;
    Moment now_;
    std::int64_t learned_ = 0;  // transitions when the policies were learned last
};

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

/// All that the course of a run depends on, as a text.
std::string settings_text(const Environment& environment, const PracticeOptions& options);

}  // namespace praxis::practice
