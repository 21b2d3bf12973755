// Methods that give each candidate a score, plan to where the best one can be executed, and execute it.
//
// A candidate is a ground skill that was tried (or any one, by option). The skill with the best score that
// can be reached is practised a few times, then scores are made anew. If none can be reached, a random skill
// is executed.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "practice/methods/planned_method.hpp"

namespace praxis::practice {

/// One candidate, as a score sees it.
struct Candidate {
    SkillIndex skill = 0;
    int tries = 0, successes = 0;
    double competence = 0, predicted = 0;
    double bonus = 0;  ///< the upper-confidence bonus, weighted
    double cost = 0;   ///< in nats; filled by methods that plan
    double score = 0;  ///< what the method makes of it
};

/// The score of a candidate that is not to be practised.
inline constexpr double kNever = -std::numeric_limits<double>::infinity();

class ScoredMethod : public PlannedMethod {
  public:
    using PlannedMethod::PlannedMethod;

    std::optional<Decision> practise(const Moment& now) final;
    void observe(const Moment& before, const Decision& decision, const Moment& after, bool success,
                 bool test) final;
    void learned() final { chosen_ = false; }
    void end_cycle() final;
    std::vector<PracticeChoice> take_choices() final;

  protected:
    /// Fills `score` of each candidate.
    virtual void score(std::span<Candidate> candidates) = 0;
    /// Whether the skill is a candidate.
    virtual bool considers(SkillIndex skill) const;
    /// What to do where no candidate is worth it or can be reached.
    virtual std::optional<Decision> otherwise(const Moment& now) { return random_skill(now); }

  private:
    void choose();
    std::optional<SkillIndex> step_to_candidate(const Moment& now);
    void record();

    std::vector<Candidate> ranking_;  // best first; empty: choose anew
    std::size_t target_ = 0;          // in `ranking_`
    bool chosen_ = false;
    int attempts_ = 0;         // since then
    bool attempting_ = false;  // the last decision was the practice itself, not the way there
    int cycle_ = 1;
    bool recorded_ = false;  // of this cycle
    std::vector<PracticeChoice> choices_;
};

}  // namespace praxis::practice
