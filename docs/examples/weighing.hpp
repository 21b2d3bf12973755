// A robot that weighs boxes: where it rehearses, with boxes of known weight, and where it works, with boxes
// that it does not know.
//
// The scale swings when a box is put on it, the longer the higher the box is, and then drifts. So a reading
// is right with a probability that depends on how long the robot waits; a bad one is no better than a coin.
// The cupboard opens with the same probabilities, by how hard the robot pulls and how stiff the door is.
#pragma once

#include <array>
#include <belief/simulated_world.hpp>
#include <functional>
#include <practice/environment.hpp>

namespace weighing {

inline constexpr std::size_t kBoxes = 2;

/// That a reading after `wait` seconds (0 to 10) is right; `height` in metres (0 to 1).
double chance_of_right_reading(double wait, double height);

/// Rehearsals: the domain `weighing`. What is read is compared with the weight that is written on the box.
class Rehearsal : public praxis::practice::SimulatedEnvironment {
  public:
    Rehearsal(std::string domain, std::string problem);

    const praxis::practice::Description& description() const override { return description_; }
    bool holds(const praxis::practice::State& state, const praxis::practice::GroundAtom& atom) const override;
    void propose(const praxis::practice::State& state, const praxis::practice::GroundSkill& skill,
                 praxis::Random& random, std::span<double> parameters) const override;
    void features(const praxis::practice::State& state, const praxis::practice::GroundSkill& skill,
                  std::span<double> features) const override;
    praxis::practice::PracticeTask sample_task(praxis::Random& random) const override;
    void execute(praxis::practice::State& state, const praxis::practice::GroundSkill& skill,
                 std::span<const double> parameters, praxis::Random& random) const override;

    /// A state with a box of this height.
    static praxis::practice::State with_box(std::size_t box, double height);

  private:
    bool can_start(const praxis::practice::State& state, const praxis::practice::GroundSkill& skill) const;

    praxis::practice::Description description_;
};

/// How the robot reads the display in earnest.
struct Look {
    std::function<double(std::size_t box, double height, praxis::Random&)> wait;  ///< seconds
    std::array<double, kBoxes> accuracy;  ///< what it believes its readings to be worth, by box
};

/// Work: the domain `sort-weight-display`.
class Robot : public praxis::belief::Environment {
  public:
    Robot(std::shared_ptr<const praxis::belief::BeliefTask> task, praxis::belief::WorldState state,
          const Look& look, std::uint64_t seed);

    praxis::belief::Execution execute(std::uint32_t action, std::stop_token stop) override;
    std::vector<praxis::belief::Answer> observe(std::uint32_t action, std::stop_token stop) override;

    bool goal_holds() const { return world_.goal_holds(); }
    int readings() const { return readings_; }
    int right_readings() const { return right_; }

  private:
    std::shared_ptr<const praxis::belief::BeliefTask> task_;
    praxis::belief::SimulatedWorld world_;
    const Look* look_;
    praxis::Random random_;
    std::array<double, kBoxes> heights_;
    int readings_ = 0, right_ = 0;
};

}  // namespace weighing
