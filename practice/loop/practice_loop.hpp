// The loop of practice: task time, free time, learning; again and again, and nothing is reset in between but
// by the world itself.
//
// A cycle: the world gives a task; the robot pursues its goal until it holds or the horizon is spent (task
// time); then the method chooses what to practise until the cycle's skills are used up (free time). The
// parameter policies are learned from all outcomes so far at the end of each cycle, and also within it, each
// time `PracticeOptions::learn_every` skills have been executed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>

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

}  // namespace praxis::practice
