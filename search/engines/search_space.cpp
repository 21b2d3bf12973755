#include "search/engines/search_space.hpp"

#include <algorithm>
#include <functional>

namespace praxis {

namespace {

/// Costs from which on sums are kept in 64 bits; below, sums of 2^18 costs fit.
constexpr std::int32_t kLargeCost = 1 << 12;

NodeLayout make_layout(const FiniteDomainTask& task, const SearchPlan& plan, std::size_t estimates) {
    const bool large =
        std::any_of(task.costs.begin(), task.costs.end(), [](auto cost) { return cost >= kLargeCost; });
    const bool bounded = plan.bound != kInfinity || plan.shared_bound != nullptr || plan.go_on;
    const bool real_cost = bounded && plan.cost_type != CostType::normal;
    return NodeLayout(large && (plan.cost_type != CostType::one || real_cost), real_cost, estimates);
}

}  // namespace

SearchSpace::SearchSpace(const PreparedTask::Parts& parts, const Query& query, const SearchPlan& plan,
                         std::size_t estimates)
    : parts_(&parts),
      query_(&query),
      uniform_costs_(std::adjacent_find(task().costs.begin(), task().costs.end(), std::not_equal_to<>()) ==
                     task().costs.end()),
      bound_(plan.bound),
      shared_bound_(plan.shared_bound),
      layout_(make_layout(*parts.task, plan, estimates)),
      registry_(parts.packer, layout_.word_count()),
      batch_(kBatch * registry_.word_count()) {
    const auto& costs = task().costs;
    if (plan.cost_type == CostType::one) {
        cost_factor_ = 0;
        cost_summand_ = 1;
    } else if (plan.cost_type == CostType::plus_one) {
        cost_summand_ = std::all_of(costs.begin(), costs.end(), [](auto cost) { return cost == 1; }) ? 0 : 1;
    }
}

StateId SearchSpace::insert_initial() {
    parts_->packer.pack(query_->initial_values.data(), registry_.candidate());
    const StateId state = registry_.intern().first;
    layout_.initialize(node(state), StateId(), 0, 0);
    return state;
}

void SearchSpace::prepare_successors(StateId state, std::span<const OperatorId> operators,
                                     const std::int32_t* values) {
    const std::size_t size = registry_.word_count();
    const std::uint32_t* before = registry_.words(state);
    for (std::size_t i = 0; i < operators.size(); ++i) {
        std::uint32_t* words = batch_.data() + i * size;
        std::copy_n(before, size, words);
        parts_->transitions.apply(operators[i], values, words);
        batch_hashes_[i] = registry_.hash(words);
        registry_.prefetch_place(batch_hashes_[i]);
    }
    for (std::size_t i = 0; i < operators.size(); ++i) registry_.prefetch_state(batch_hashes_[i]);
}

std::vector<OperatorId> SearchSpace::plan_to(StateId state) {
    std::vector<OperatorId> plan;
    for (StateId parent = layout_.parent(node(state)); parent.valid(); parent = layout_.parent(node(state))) {
        plan.push_back(operator_between(parent, state));
        state = parent;
    }
    std::reverse(plan.begin(), plan.end());
    return plan;
}

OperatorId SearchSpace::operator_between(StateId parent, StateId child) {
    std::vector<std::int32_t> values = buffer();
    read(parent, values);
    OperatorId best;
    parts_->generator.for_each(values.data(), [&](OperatorId op) {
        if (best.valid() && task().costs[op.index()] >= task().costs[best.index()]) return;
        parts_->transitions.apply(op, values.data(), registry_.candidate_from(parent));
        if (registry_.candidate_equals(child)) best = op;
    });
    return best;
}

}  // namespace praxis
