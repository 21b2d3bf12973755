// Baselines that do not choose skills by score.
#pragma once

#include "practice/methods/planned_method.hpp"

namespace praxis::practice {

/// Executes random skills.
class RandomSkillsMethod : public PlannedMethod {
  public:
    using PlannedMethod::PlannedMethod;
    std::optional<Decision> practise(const Moment& now) override { return random_skill(now); }
};

/// Does the task again and again, there and back.
class TaskRepeatMethod : public PlannedMethod {
  public:
    using PlannedMethod::PlannedMethod;
    std::optional<Decision> practise(const Moment& now) override { return repeat_task(now); }
};

}  // namespace praxis::practice
