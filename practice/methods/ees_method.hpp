// Estimate, extrapolate, situate: practise the skill whose improvement makes the tasks' plans most likely to
// succeed.
//
// The score of a skill is minus the mean cost of the cheapest plans for the tasks seen, if the skill had the
// competence that one more cycle of practice is expected to bring, plus the upper-confidence bonus. Skills
// that never failed are not practised. Kumar et al., "Practice Makes Perfect", RSS 2024.
#pragma once

#include "practice/methods/scored_method.hpp"

namespace praxis::practice {

class EesMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  private:
    void score(std::span<Candidate> candidates) override;
};

}  // namespace praxis::practice
