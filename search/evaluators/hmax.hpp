// The maximum heuristic (Bonet and Geffner 2001): a rule costs its own cost and that of its most expensive
// precondition.
#pragma once

#include <memory>

#include "search/evaluators/evaluator.hpp"
#include "search/evaluators/relaxed_exploration.hpp"

namespace praxis {

/// Safe, admissible and consistent for every task, conditional effects and axioms included.
class HmaxEvaluator final : public Evaluator {
  public:
    HmaxEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);
    /// `relaxed` is the task's relaxation for the goal and the cost type.
    HmaxEvaluator(const FiniteDomainTask& task, std::shared_ptr<const RelaxedTask> relaxed);

    Estimate evaluate(StateView state) override { return exploration_.run(state); }
    std::uint64_t effort() const override { return exploration_.effort(); }
    bool safe() const override { return true; }
    bool admissible() const override { return true; }
    bool consistent() const override { return true; }

  private:
    RelaxedExploration<Combine::maximum> exploration_;
};

}  // namespace praxis
