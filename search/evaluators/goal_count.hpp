// How many goals are still open.
#pragma once

#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// The number of goal facts that do not hold, whatever operators cost. Never kDeadEnd, hence safe; neither
/// admissible (one operator may reach several goals, or cost nothing) nor consistent.
class GoalCountEvaluator final : public Evaluator {
  public:
    GoalCountEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);

    Estimate evaluate(StateView state) override;
    std::uint64_t effort() const override { return 10 + goal_.size(); }
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

  private:
    std::vector<Fact> goal_;
};

}  // namespace praxis
