// The additive heuristic (Bonet and Geffner 2001): a rule costs its own cost and those of all its
// preconditions.
#pragma once

#include "search/evaluators/evaluator.hpp"
#include "search/evaluators/relaxed_plan.hpp"

namespace praxis {

/// Safe for every task; neither admissible nor consistent. Prefers the operators of the relaxed plan that its
/// best supporters make, as FFEvaluator does. The task must outlive the evaluator.
class AddEvaluator final : public Evaluator {
  public:
    AddEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);
    /// `relaxed` is the task's relaxation for the goal and the cost type.
    AddEvaluator(const FiniteDomainTask& task, std::shared_ptr<const RelaxedTask> relaxed);

    Estimate evaluate(StateView state) override;
    std::span<const OperatorId> preferred() const override { return preferred_; }
    void request_preferred() override { preferred_wanted_ = true; }
    std::uint64_t effort() const override { return exploration_.effort(); }
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

  private:
    RelaxedExploration<Combine::sum> exploration_;
    RelaxedPlan plan_;
    bool preferred_wanted_ = false;
    std::span<const OperatorId> preferred_;
};

}  // namespace praxis
