#include "search/engines/state_evaluator.hpp"

namespace praxis {

StateEvaluator::StateEvaluator(std::vector<Heuristic> heuristics, const SearchPlan& plan)
    : heuristics_(std::move(heuristics)),
      in_open_list_(heuristics_of(plan.open)),
      preferred_from_(plan.preferred),
      estimates_(heuristics_.size(), 0),
      best_(heuristics_.size(), kDeadEnd) {
    for (std::size_t i : preferred_from_) heuristics_[i].evaluator->request_preferred();
    for (const Heuristic& heuristic : heuristics_) {
        safe_.push_back(heuristic.evaluator->safe());
        if (heuristic.evaluator->path_dependent()) path_dependent_.push_back(heuristic.evaluator.get());
    }
    if (plan.expansion == Expansion::eager && (plan.reopen_closed || uses_g(plan.open))) {
        for (std::size_t i : in_open_list_) (heuristics_[i].cheap ? cheap_ : remembered_).push_back(i);
    }
}

void StateEvaluator::start(StateId initial, std::span<const std::int32_t> values) {
    for (Evaluator* evaluator : path_dependent_) evaluator->start(initial, values);
}

void StateEvaluator::follow(StateId parent, OperatorId op, StateId child,
                            std::span<const std::int32_t> values) {
    for (Evaluator* evaluator : path_dependent_) evaluator->follow(parent, op, child, values);
}

bool StateEvaluator::evaluate(StateId state, std::span<const std::int32_t> values, std::int64_t g) {
    for (Evaluator* evaluator : path_dependent_) evaluator->at(state);
    for (std::size_t i = 0; i < heuristics_.size(); ++i) {
        estimates_[i] = estimate(i, values, g);
        if (estimates_[i] == kDeadEnd && safe_[i]) return false;
    }
    return true;
}

Estimate StateEvaluator::estimate(std::size_t i, std::span<const std::int32_t> values, std::int64_t g) {
    const Heuristic& heuristic = heuristics_[i];
    if (!heuristic.given.empty()) {
        given_.clear();
        for (const Key& key : heuristic.given) given_.push_back(key.value({estimates_, g}));
        heuristic.evaluator->given(given_);
    }
    const Estimate result = heuristic.evaluator->evaluate(values);
    effort_ += heuristic.evaluator->effort();
    return result;
}

bool StateEvaluator::progress() {
    bool result = false;
    for (std::size_t i : in_open_list_) {
        if (estimates_[i] >= best_[i]) continue;
        best_[i] = estimates_[i];
        result = true;
    }
    return result;
}

std::optional<std::int32_t> StateEvaluator::best_estimate() const {
    if (in_open_list_.empty() || best_[in_open_list_[0]] == kDeadEnd) return std::nullopt;
    return best_[in_open_list_[0]];
}

const std::vector<OperatorId>& StateEvaluator::preferred() {
    preferred_.clear();
    if (preferred_from_.size() == 1) {
        const auto operators = heuristics_[preferred_from_[0]].evaluator->preferred();
        preferred_.assign(operators.begin(), operators.end());
        return preferred_;
    }
    for (std::size_t i : preferred_from_) {
        for (OperatorId op : heuristics_[i].evaluator->preferred()) {
            if (op.index() >= seen_.size()) seen_.resize(op.index() + 1, false);
            if (seen_[op.index()]) continue;
            seen_[op.index()] = true;
            preferred_.push_back(op);
        }
    }
    for (OperatorId op : preferred_) seen_[op.index()] = false;
    return preferred_;
}

void StateEvaluator::evaluate_preferred(StateId state, std::span<const std::int32_t> values, std::int64_t g) {
    for (Evaluator* evaluator : path_dependent_) evaluator->at(state);
    for (std::size_t i : preferred_from_) estimates_[i] = estimate(i, values, g);
}

void StateEvaluator::remember(const NodeLayout& layout, std::uint32_t* node) const {
    for (std::size_t i = 0; i < remembered_.size(); ++i)
        layout.set_estimate(node, i, estimates_[remembered_[i]]);
}

void StateEvaluator::restore(const NodeLayout& layout, const std::uint32_t* node,
                             std::span<const std::int32_t> values) {
    for (std::size_t i = 0; i < remembered_.size(); ++i)
        estimates_[remembered_[i]] = layout.estimate(node, i);
    for (std::size_t i : cheap_) estimates_[i] = heuristics_[i].evaluator->evaluate(values);
}

}  // namespace praxis
