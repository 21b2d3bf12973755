// The estimate that knows only whether the goal is reached.
#pragma once

#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// 0 in goal states, elsewhere the cost of the cheapest operator. Safe, admissible and consistent for every
/// task.
class BlindEvaluator final : public Evaluator {
  public:
    BlindEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);

    Estimate evaluate(StateView state) override;
    bool safe() const override { return true; }
    bool admissible() const override { return true; }
    bool consistent() const override { return true; }

  private:
    std::vector<Fact> goal_;
    Estimate cheapest_ = 0;
};

}  // namespace praxis
