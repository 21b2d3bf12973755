// Follows a plan that was made beforehand for all readings, and leaves the rest to the loop where something
// is read that the plan does not speak of.
#pragma once

#include <memory>
#include <span>

#include "belief/policies/policy.hpp"

namespace praxis::belief {

class PreparedPolicy : public Policy {
  public:
    explicit PreparedPolicy(std::shared_ptr<const ConditionalPlan> plan);

    Decision next(Belief& belief, const Budget& budget) override;
    void observed(std::span<const Answer> answers) override;
    void failed() override { lost_ = true; }

  private:
    std::shared_ptr<const ConditionalPlan> plan_;
    std::uint32_t node_ = 0;
    bool begun_ = false;
    bool lost_ = false;
};

/// The best plan for all readings, if the task is so small that it takes a fraction of a second at most to
/// find; null otherwise. Equally good on every machine: the limits are counts.
std::shared_ptr<const ConditionalPlan> prepare_best(const std::shared_ptr<const BeliefTask>& task,
                                                    const Budget& budget = {});

}  // namespace praxis::belief
