// Executing plans of a query, for those who change plans.
//
// Plans are compared by cost and then by the number of steps, so that steps which cost nothing are not
// wanted either.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "search/engines/prepared_parts.hpp"

namespace praxis {

/// What a plan costs: first by the task's costs, then by its number of steps.
struct PlanCost {
    std::int64_t cost = 0;
    std::int64_t steps = 0;
    friend auto operator<=>(const PlanCost&, const PlanCost&) = default;
    friend PlanCost operator+(PlanCost a, PlanCost b) { return {a.cost + b.cost, a.steps + b.steps}; }
    friend PlanCost operator-(PlanCost a, PlanCost b) { return {a.cost - b.cost, a.steps - b.steps}; }
};

PlanCost cost_of(const FiniteDomainTask& task, std::span<const OperatorId> plan);

/// Runs plans by the task's semantics. Refers to its arguments; belongs to one thread.
class PlanExecution {
  public:
    PlanExecution(const PreparedTask::Parts& parts, const Query& query)
        : parts_(&parts), query_(&query), before_(parts.task->variable_count()) {}

    /// Values below are of all variables, complete.
    std::vector<std::int32_t> initial();
    bool applicable(OperatorId op, const std::vector<std::int32_t>& values) const {
        return all_hold(parts_->task->preconditions[op.index()], values.data());
    }
    /// Turns the state into the one after `op`.
    void apply(OperatorId op, std::vector<std::int32_t>& values);
    bool goal(const std::vector<std::int32_t>& values) const { return all_hold(query_->goal, values.data()); }
    PlanCost cost(OperatorId op) const { return {parts_->task->costs[op.index()], 1}; }
    /// The complete values of a packed state.
    void read(const std::uint32_t* words, std::vector<std::int32_t>& values) {
        parts_->packer.unpack(words, values.data());
        parts_->axioms.complete(values.data(), scratch_);
    }

    /// The states of the plan, from the initial state to the one after its last step, packed one after the
    /// other; nothing if it is not a plan of the query.
    std::optional<std::vector<std::uint32_t>> trace(std::span<const OperatorId> plan);

  private:
    const PreparedTask::Parts* parts_;
    const Query* query_;
    std::vector<std::int32_t> before_;
    AxiomEvaluator::Scratch scratch_;
};

}  // namespace praxis
