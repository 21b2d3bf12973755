// Estimate, extrapolate, situate: practise the skill whose improvement makes the tasks' plans most likely to
// succeed.
//
// The score of a skill is minus the mean cost of the cheapest plans for the tasks seen, if the skill had the
// competence that more practice is expected to bring, plus the upper-confidence bonus. Kumar et al.,
// "Practice Makes Perfect", RSS 2024.
#pragma once

#include "practice/methods/scored_method.hpp"

namespace praxis::practice {

/// As published: candidates are the skills tried, those that never failed are left out; where none is left, a
/// random skill is executed.
class PublishedEesMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  protected:
    /// Fills `cost` of each candidate; the mean cost if none improves (0 without candidates).
    double situate(std::span<Candidate> candidates);

  private:
    void score(std::span<Candidate> candidates) override;
};

/// The same, but nothing is practised from which no gain is expected: skills without parameters, and those
/// whose improvement makes no task's plan cheaper. Skills may be practised before a task has tried them.
/// Where no candidate is left, the task is done again and again, which shows what fails.
class EesMethod : public PublishedEesMethod {
  public:
    using PublishedEesMethod::PublishedEesMethod;

  private:
    void score(std::span<Candidate> candidates) override;
    bool considers(SkillIndex skill) const override;
    std::optional<Decision> otherwise(const Moment& now) override { return repeat_task(now); }
};

}  // namespace praxis::practice
