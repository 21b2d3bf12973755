#include "search/improve/plan_execution.hpp"

namespace praxis {

PlanCost cost_of(const FiniteDomainTask& task, std::span<const OperatorId> plan) {
    PlanCost sum;
    for (OperatorId op : plan) sum = sum + PlanCost{task.costs[op.index()], 1};
    return sum;
}

std::vector<std::int32_t> PlanExecution::initial() {
    std::vector<std::int32_t> values = query_->initial_values;
    parts_->axioms.complete(values.data(), scratch_);
    return values;
}

void PlanExecution::apply(OperatorId op, std::vector<std::int32_t>& values) {
    if (parts_->transitions.conditional(op)) {
        before_ = values;
        parts_->transitions.apply(op, before_.data(), values.data());
    } else {
        parts_->transitions.apply(op, nullptr, values.data());
    }
    parts_->axioms.complete(values.data(), scratch_);
}

std::optional<std::vector<std::uint32_t>> PlanExecution::trace(std::span<const OperatorId> plan) {
    const std::size_t words = parts_->packer.word_count();
    std::vector<std::uint32_t> states((plan.size() + 1) * words);
    std::vector<std::int32_t> values = initial();
    parts_->packer.pack(values.data(), states.data());
    for (std::size_t i = 0; i < plan.size(); ++i) {
        if (!applicable(plan[i], values)) return std::nullopt;
        apply(plan[i], values);
        parts_->packer.pack(values.data(), states.data() + (i + 1) * words);
    }
    if (!goal(values)) return std::nullopt;
    return states;
}

}  // namespace praxis
