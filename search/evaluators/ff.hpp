// The FF heuristic (Hoffmann and Nebel 2001) with hadd's best supporters (Keyder and Geffner 2008): the cost
// of a relaxed plan.
#pragma once

#include "search/evaluators/evaluator.hpp"
#include "search/evaluators/relaxed_plan.hpp"

namespace praxis {

/// Safe for every task; neither admissible nor consistent. Prefers the operators of the relaxed plan that can
/// be applied in the state (helpful actions). The task must outlive the evaluator.
class FFEvaluator final : public Evaluator {
  public:
    FFEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type);
    /// `relaxed` is the task's relaxation for the goal and the cost type.
    FFEvaluator(const FiniteDomainTask& task, std::shared_ptr<const RelaxedTask> relaxed);

    Estimate evaluate(StateView state) override;
    std::span<const OperatorId> preferred() const override { return preferred_; }
    void request_preferred() override { preferred_wanted_ = true; }
    /// The relaxed plan of the state last evaluated, each operator once, in no order to execute; empty for
    /// dead ends.
    std::span<const OperatorId> relaxed_plan() const { return relaxed_plan_; }
    std::uint64_t effort() const override { return exploration_.effort(); }
    bool safe() const override { return true; }
    bool admissible() const override { return false; }
    bool consistent() const override { return false; }

  private:
    RelaxedExploration<Combine::sum> exploration_;
    RelaxedPlan plan_;
    bool preferred_wanted_ = false;
    std::span<const OperatorId> preferred_;
    std::span<const OperatorId> relaxed_plan_;
};

}  // namespace praxis
