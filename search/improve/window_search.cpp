#include "search/improve/window_search.hpp"

#include <algorithm>

namespace praxis {

WindowSearch::WindowSearch(const PreparedTask::Parts& parts, Query query, const Budget& budget,
                           std::size_t max_states)
    : parts_(parts),
      query_(std::move(query)),
      budget_(budget),
      max_states_(max_states),
      execution_(parts, query_),
      evaluator_(*parts.task, query_.goal, CostType::normal),
      registry_(parts.packer, 0),
      values_(parts.task->variable_count()),
      child_values_(parts.task->variable_count()) {}

std::optional<std::vector<OperatorId>> WindowSearch::run(PlanCost bound) {
    parts_.packer.pack(query_.initial_values.data(), registry_.candidate());
    child_values_ = query_.initial_values;
    reach(registry_.intern().first.index(), {{}, kNone, OperatorId(), 0}, bound);
    while (!queue_.empty() && registry_.size() < max_states_) {
        if (budget_.exhausted() != Stop::none) return std::nullopt;
        const QueueEntry entry = queue_.top();
        queue_.pop();
        if (entry.cost > nodes_[entry.state].cost) continue;
        execution_.read(registry_.words(StateId(entry.state)), values_);
        if (execution_.goal(values_)) return steps_to(entry.state);
        expand(entry.state, bound);
    }
    return std::nullopt;
}

// A way to the state, whose values are `child_values_` if it is new.
void WindowSearch::reach(std::uint32_t state, const Node& node, PlanCost bound) {
    if (state == nodes_.size()) {
        nodes_.push_back(node);
        nodes_[state].estimate = evaluator_.evaluate(child_values_);
    } else {
        if (node.cost >= nodes_[state].cost) return;
        const Estimate estimate = nodes_[state].estimate;
        nodes_[state] = node;
        nodes_[state].estimate = estimate;
    }
    const std::int64_t estimate = nodes_[state].estimate;
    const PlanCost least = node.cost + PlanCost{estimate, 0};
    if (estimate != kDeadEnd && least < bound) queue_.push({least, estimate, node.cost, state});
}

void WindowSearch::expand(std::uint32_t state, PlanCost bound) {
    const PlanCost cost = nodes_[state].cost;
    parts_.generator.for_each(values_.data(), [&](OperatorId op) {
        const PlanCost child_cost = cost + execution_.cost(op);
        if (child_cost >= bound) return;
        parts_.transitions.apply(op, values_.data(), registry_.candidate_from(StateId(state)));
        const auto [child, is_new] = registry_.intern();
        if (is_new) {
            if (budget_.exhausted() != Stop::none) {
                nodes_.push_back({child_cost, state, op, kDeadEnd});
                return;
            }
            execution_.read(registry_.words(child), child_values_);
        }
        reach(child.index(), {child_cost, state, op, 0}, bound);
    });
}

std::vector<OperatorId> WindowSearch::steps_to(std::uint32_t state) const {
    std::vector<OperatorId> steps;
    for (; nodes_[state].parent != kNone; state = nodes_[state].parent) steps.push_back(nodes_[state].op);
    std::ranges::reverse(steps);
    return steps;
}

}  // namespace praxis
