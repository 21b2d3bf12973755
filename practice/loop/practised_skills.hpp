// The robot's skills with the parameters that practice has found: for those who call skills by name alone, as
// the loop of belief does.
#pragma once

#include <cstdint>
#include <map>

#include "practice/loop/learner.hpp"
#include "practice/loop/skill_world.hpp"

namespace praxis::practice {

class PractisedSkills : public Skills {
  public:
    /// Refers to the learner and the skills. `see` gives the state that parameters depend on; `seed` draws
    /// the candidates of which the learner takes the best.
    PractisedSkills(const Learner& learner, Skills& skills, SkillWorld::See see, std::uint64_t seed = 0);

    /// Chooses the parameters of a skill that was practised, unless they are given; hands on all others as
    /// they are.
    Execution execute(const ActionName& action, std::span<const double> parameters,
                      std::stop_token stop) override;

  private:
    const Learner* learner_;
    Skills* skills_;
    SkillWorld::See see_;
    Random random_;
    std::map<ActionName, SkillIndex> practised_;  ///< those with parameters
};

}  // namespace praxis::practice
