// Ball and ring: the ball has to get onto the smooth table, where only the ring keeps it.
//
// Five tables of radius r = 0.098 stand on a circle of radius 1/3 around (0.5, 0.5); lengths are in metres.
// The ball rolls off every table. The ring stays wherever it is put on a plain table; on the smooth one only
// within the *sticky disc*, of radius 0.35 r, whose centre is drawn anew for each task, at a distance uniform
// in [0, 0.65 r] and in any direction. What falls lies on the floor. All other skills succeed. A placement is
// proposed at a distance uniform in [0, r - the thing's diameter] and in any direction from the centre of the
// table; 43 % of those of the ring stay, and 54 % if it is always the centre.
//
// The plan that works takes exactly the 8 skills of the horizon; PDDL promises one of 4 that never works.
//
// Features. `raw`: the placement is (x, y), and the features are all numbers of robot, ball, ring and table;
// those of the table are the relevant ones. `relative`: the placement is (dx, dy) from the centre of the
// sticky disc, or of a plain table; proposals are the same points as before.
//
// Source: the environment "Ball-Ring" of Kumar et al., RSS 2024 (their code calls it
// ball_and_cup_sticky_table).
#pragma once

#include "practice/environments/checked_environment.hpp"

namespace praxis::practice {

class BallRing final : public CheckedEnvironment {
  public:
    enum class Features { raw, relative };
    explicit BallRing(Features features = Features::raw);
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
    static Signatures signatures();

    Features features_;
};

}  // namespace praxis::practice
