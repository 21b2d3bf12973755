// The kitchen: pick, place and sweep with stated success models, and things to practise that no task needs.
//
// Three things (cup, plate, brush) and two heaps of crumbs are spread over counter, table, shelf, sink and
// floor. A task asks for a dish in another place, for both heaps in the bin, for a dish and a heap, or for a
// dish and both heaps, equally often.
//
// Success models (see stated_environment.hpp), with width 0.05 and ceiling 0.97; handles, spreads and
// stiffness are drawn uniformly in [-1, 1]:
//
//     skill                 parameters        optimum                             tolerance
//     pick                  grip, lift        handle of the thing, its weight     0.80
//     place                 tilt, height      half of its handle, the place's level  0.75
//     sweep                 direction, force  spread of the heap, its coarseness  0.70
//     open-, close-drawer   pull, height      stiffness of the drawer, 0.4        0.60
//
// Placing on the floor always succeeds, and so do going and tipping out; switching the lamp on or off (force,
// angle) succeeds with probability 0.3 whatever the parameters. A pick that fails turns the handle; what is
// placed badly falls to the floor; crumbs that are swept badly spread anew.
//
// Unpractised, a robot that replans solves about 38 % of the tasks within the 12 skills of the horizon; with
// optimal parameters 99 %.
#pragma once

#include "practice/environments/stated_environment.hpp"

namespace praxis::practice {

class Kitchen final : public StatedEnvironment {
  public:
    Kitchen();
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
