// The kitchen: pick, place and sweep with stated success models, and things to practise that no task needs.
//
// Three things (cup, plate, brush) and two heaps of crumbs are spread over counter, table, shelf, sink and
// floor. A task asks for a dish in another place, for a heap in the bin, for both, or for both heaps in the
// bin.
//
// Success models (see stated_environment.hpp); handles, spreads and stiffness are drawn uniformly in [-1, 1]:
//
//     skill          parameters          optimum                                tolerance
//     pick           grip, lift          handle of the thing, its weight        0.80
//     place          tilt, height        half of its handle, level of the place 0.75   (onto the floor:
//     certain) sweep          direction, force    spread of the heap, its coarseness     0.70 open-,
//     close-drawer  pull, height  stiffness of the drawer, 0.4           0.60 switch-lamp-on, -off  force,
//     angle  does not matter: 0.3 always
//
// with width 0.05 and ceiling 0.97. A pick that fails turns the handle; what is placed badly falls to the
// floor; crumbs that are swept badly spread anew. Going and tipping out always succeed.
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
