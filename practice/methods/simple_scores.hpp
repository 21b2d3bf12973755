// The baselines that score skills without looking at tasks.
#pragma once

#include "practice/methods/scored_method.hpp"

namespace praxis::practice {

/// The rate of failures, plus the upper-confidence bonus.
class FailFocusMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  private:
    void score(std::span<Candidate> candidates) override;
};

/// How much competence one more cycle is expected to bring, plus the upper-confidence bonus (Stout and Barto
/// 2010).
class CompetenceGradientMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  private:
    void score(std::span<Candidate> candidates) override;
};

/// The skill tried least.
class SkillDiversityMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  private:
    void score(std::span<Candidate> candidates) override;
};

/// A random one of the skills that tasks have used.
class TaskRelevantMethod : public ScoredMethod {
  public:
    using ScoredMethod::ScoredMethod;

  private:
    void score(std::span<Candidate> candidates) override;
};

}  // namespace praxis::practice
