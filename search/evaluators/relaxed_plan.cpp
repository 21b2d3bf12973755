#include "search/evaluators/relaxed_plan.hpp"

#include <algorithm>

namespace praxis {

RelaxedPlan::RelaxedPlan(const FiniteDomainTask& task, const RelaxedTask& relaxed)
    : task_(task),
      relaxed_(relaxed),
      proposition_marks_(relaxed.proposition_count, 0),
      operator_marks_(relaxed.operator_count, 0),
      preferred_marks_(relaxed.operator_count, 0) {}

Estimate RelaxedPlan::extract(const RelaxedExploration<Combine::sum>& exploration, StateView state) {
    if (++stamp_ == 0) {
        for (auto* marks : {&proposition_marks_, &operator_marks_, &preferred_marks_})
            std::ranges::fill(*marks, 0u);
        stamp_ = 1;
    }
    operators_.clear();
    preferred_.clear();
    cost_ = 0;
    need(relaxed_.goal);
    while (!open_.empty()) {
        const std::uint32_t proposition = open_.back();
        open_.pop_back();
        const std::uint32_t rule = exploration.supporter(proposition);
        if (rule == RelaxedTask::kNone) continue;
        for (const std::uint32_t precondition : relaxed_.rule(rule).preconditions) need(precondition);
        use(relaxed_.part(rule, proposition), state);
    }
    return static_cast<Estimate>(std::min<std::int64_t>(cost_, kDeadEnd - 1));
}

void RelaxedPlan::need(std::uint32_t proposition) {
    if (proposition_marks_[proposition] == stamp_) return;
    proposition_marks_[proposition] = stamp_;
    open_.push_back(proposition);
}

void RelaxedPlan::use(std::uint32_t part, StateView state) {
    const std::uint32_t op = relaxed_.operator_of[part];
    if (op == relaxed_.operator_count) return;
    if (operator_marks_[op] != stamp_) {
        operator_marks_[op] = stamp_;
        operators_.emplace_back(op);
        cost_ += relaxed_.costs[op];
    }
    if (preferred_marks_[op] == stamp_) return;
    const std::uint32_t condition = relaxed_.condition_of.empty() ? 0 : relaxed_.condition_of[part];
    if (all_hold(task_.preconditions[op], state.data()) &&
        all_hold(task_.conditions[condition], state.data())) {
        preferred_marks_[op] = stamp_;
        preferred_.emplace_back(op);
    }
}

}  // namespace praxis
