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

/// Does the task again and again: back to what held at its beginning, then to its goal; with exploring
/// parameters.
class TaskRepeatMethod : public PlannedMethod {
  public:
    using PlannedMethod::PlannedMethod;
    void begin_practice() override;
    std::optional<Decision> practise(const Moment& now) override;

  private:
    bool back_ = true;
};

}  // namespace praxis::practice
