// A simulated environment as a world.
#pragma once

#include "practice/environment.hpp"

namespace praxis::practice {

/// Chance is a function of the seed and of how many skills were executed and tasks given before, so that a
/// run taken up from a journal meets the same world.
class SimulatedWorld : public World {
  public:
    /// `reset`: each new task begins in its own initial state; otherwise only the first one does, and nothing
    /// is ever put back.
    SimulatedWorld(const SimulatedEnvironment& environment, std::uint64_t seed, bool reset = true)
        : environment_(&environment), seed_(seed), reset_(reset) {}

    std::vector<GroundAtom> next_task() override;
    const State& observe() override { return state_; }
    void execute(const GroundSkill& skill, std::span<const double> parameters) override;
    void resume(const State& state, std::uint64_t skills, std::uint64_t tasks) override;

  private:
    const SimulatedEnvironment* environment_;
    std::uint64_t seed_;
    bool reset_;
    std::uint64_t skills_ = 0, tasks_ = 0;
    State state_;
};

/// A stream of random numbers of its own for each use.
Random random_stream(std::uint64_t seed, std::uint64_t purpose, std::uint64_t number = 0);

}  // namespace praxis::practice
