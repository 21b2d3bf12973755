// The light switch: a robot walks along a row of cells to a dimmer and has to find the level that is wanted.
//
// The light is on when its level is within 0.1 of its target; turn-on and turn-off add their parameter d to
// the level, which stays in [0, 1]. The level starts at 0, the target is uniform in [0.5, 1]. Proposals are
// uniform in [-1, 1], so that about every tenth succeeds. Walking always succeeds; jump-to-light never does,
// and its parameter means nothing. The plan that skips the jump takes `cells` skills; the horizon is two
// more.
//
// Source: the environment "Light Switch" of Kumar et al., RSS 2024 (their code calls it grid_row).
#pragma once

#include "practice/environments/checked_environment.hpp"

namespace praxis::practice {

class LightSwitch final : public CheckedEnvironment {
  public:
    /// Throws std::invalid_argument unless there are 3 to 10,000 cells.
    explicit LightSwitch(int cells = 100);
    PracticeTask sample_task(Random& random) const override;

  protected:
    bool atom_holds(const State& state, const GroundAtom& atom) const override;
    bool can_start(const State& state, const GroundSkill& skill) const override;
    void act(State& state, const GroundSkill& skill, std::span<const double> parameters,
             Random& random) const override;
    void draw_parameters(const State& state, const GroundSkill& skill, Random& random,
                         std::span<double> parameters) const override;
    void write_features(const State& state, const GroundSkill& skill,
                        std::span<double> features) const override;

  private:
    static Signatures signatures(std::int32_t last_cell);

    std::int32_t last_cell_;
};

}  // namespace praxis::practice
