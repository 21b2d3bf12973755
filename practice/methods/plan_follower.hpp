// Follows plans to a goal, and makes a new one where a skill has failed or the world is not as planned.
#pragma once

#include <optional>
#include <vector>

#include "practice/loop/learner.hpp"

namespace praxis::practice {

class PlanFollower {
  public:
    PlanFollower(const Learner& learner, CostPlanner& planner) : learner_(&learner), planner_(&planner) {}

    /// The next skill of a plan to `goal`; none: there is no plan, or the goal holds.
    std::optional<SkillIndex> next(const std::vector<std::int32_t>& values, const std::vector<Fact>& goal);
    /// What came of it.
    void observe(bool success) { valid_ = valid_ && success; }
    /// The next call plans anew.
    void forget() {
        valid_ = false;
        place_ = 0;
    }
    /// The last call of `next` planned anew because the plan before had failed.
    bool replanned() const { return replanned_; }

  private:
    const Learner* learner_;
    CostPlanner* planner_;
    std::vector<Fact> goal_;
    std::vector<SkillIndex> plan_;
    std::size_t place_ = 0;
    bool valid_ = false;
    bool replanned_ = false;
};

}  // namespace praxis::practice
