// Relaxed plans: the operators that best supporters chain back to from the goal.
#pragma once

#include <vector>

#include "search/evaluators/relaxed_exploration.hpp"

namespace praxis {

/// Extracts relaxed plans from explorations of one task; reuses its memory. The task must outlive it.
class RelaxedPlan {
  public:
    RelaxedPlan(const FiniteDomainTask& task, const RelaxedTask& relaxed);

    /// Collects the plan of an exploration that reached the goal from `state`; returns the sum of its
    /// operators' costs, at most `kDeadEnd` - 1.
    Estimate extract(const RelaxedExploration<Combine::sum>& exploration, StateView state);

    /// The plan's operators, each once, goals first.
    std::span<const OperatorId> operators() const { return operators_; }
    /// Those of which a rule in the plan has all its conditions in the state; they are applicable there.
    std::span<const OperatorId> preferred() const { return preferred_; }

  private:
    void need(std::uint32_t proposition);
    void use(std::uint32_t part, StateView state);

    const FiniteDomainTask& task_;
    const RelaxedTask& relaxed_;
    std::uint32_t stamp_ = 0;  ///< number of this extraction; marks are equal to it
    std::vector<std::uint32_t> proposition_marks_;
    std::vector<std::uint32_t> operator_marks_;
    std::vector<std::uint32_t> preferred_marks_;
    std::vector<std::uint32_t> open_;
    std::vector<OperatorId> operators_;
    std::vector<OperatorId> preferred_;
    std::int64_t cost_ = 0;
};

}  // namespace praxis
