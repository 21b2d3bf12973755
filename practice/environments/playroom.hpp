// The playroom: sweeping two toys into a bin, which takes ten skills and more to prepare.
//
// Two toys, a bin and a sweeper are about shelf, table, closet and corner. A toy starts in the corner as
// often as elsewhere, the bin on the shelf or the table, the sweeper in the closed closet, the chair in the
// corner. The task is to have both toys in the bin; the robot has no other way than to sweep them.
//
// Success models (see stated_environment.hpp), with width 0.05 and ceiling 0.97; angles, spread and stiffness
// are drawn uniformly in [-1, 1]:
//
//     skill            parameters        optimum                               tolerance
//     pick-toy         grip, lift        angle of the toy, its weight          0.9
//     open-closet      pull, height      stiffness of the closet, 0.3          0.8
//     pull-chair-away  grip, pull        angle of the chair, 0.5               0.8
//     sweep            direction, force  mean angle of the toys, half spread   0.3
//     dump             tilt, height      half of the toys' spread, -0.2        0.8
//
// All other skills always succeed. A failure turns what was handled; a sweep that fails spreads the toys
// anew, and with probability 0.3 one of them rolls to the table.
//
// Unpractised, a robot that replans solves about 19 % of the tasks within the 24 skills of the horizon; with
// optimal parameters nearly all. Plans take 9 to 18 skills; there are 2,416 symbolic states.
#pragma once

#include "practice/environments/stated_environment.hpp"

namespace praxis::practice {

class Playroom final : public StatedEnvironment {
  public:
    Playroom();
    PracticeTask sample_task(Random& random) const override;
    void optimum(const State& state, const GroundSkill& skill, std::span<double> parameters) const override;

  protected:
    bool atom_holds(const State& state, const GroundAtom& atom) const override;
    bool can_start(const State& state, const GroundSkill& skill) const override;
    LogisticSuccess model(const State& state, const GroundSkill& skill) const override;
    void succeed(State& state, const GroundSkill& skill, Random& random) const override;
    void fail(State& state, const GroundSkill& skill, Random& random) const override;
    void write_features(const State& state, const GroundSkill& skill,
                        std::span<double> features) const override;

  private:
    static Signatures signatures();
};

}  // namespace praxis::practice
