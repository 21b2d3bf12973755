#include "search/evaluators/relaxed_counter.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace praxis {

RelaxedCounterEvaluator::RelaxedCounterEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal,
                                                 std::shared_ptr<const RelaxedTask> relaxed)
    : task_(task),
      ff_(task, std::move(relaxed)),
      goal_count_(task, goal, CostType::one),
      is_new_(task.fact_count(), 0) {}

void RelaxedCounterEvaluator::start(StateId, StateView state) {
    Root root = make_root(state, goal_count_.evaluate(state));
    words_ = std::clamp<std::size_t>((root.facts.size() + 31) / 32, 1, kMaxWords);
    records_.emplace(1 + words_);
    roots_.clear();
    commit(std::move(root));
}

RelaxedCounterEvaluator::Root RelaxedCounterEvaluator::make_root(StateView state, Estimate open_goals) {
    Root root{open_goals, ff_.evaluate(state) == kDeadEnd, {}};
    pending_ += ff_.effort();
    for (const OperatorId op : ff_.relaxed_plan()) {
        for (const GroundEffect& effect : task_.effects[op.index()]) {
            const std::uint32_t fact = task_.fact_number(effect.fact);
            if (is_new_[fact] || state[static_cast<std::size_t>(effect.fact.variable)] == effect.fact.value)
                continue;
            is_new_[fact] = 1;
            root.facts.push_back(fact);
        }
    }
    for (const std::uint32_t fact : root.facts) is_new_[fact] = 0;
    return root;
}

void RelaxedCounterEvaluator::commit(Root root) {
    if (root.facts.size() > words_ * 32) root.facts.resize(words_ * 32);
    std::ranges::sort(root.facts);
    std::uint32_t* record = records_->next();
    record[0] = static_cast<std::uint32_t>(roots_.size());
    std::fill_n(record + 1, words_, 0u);
    roots_.push_back(std::move(root));
    records_->commit();
}

void RelaxedCounterEvaluator::follow(StateId parent, OperatorId op, StateId child, StateView state) {
    RecordPool& records = *records_;
    if (child.index() < records.size()) return;
    const std::uint32_t* before = records[parent.index()];
    const Root& root = roots_[before[0]];
    const Estimate open_goals = goal_count_.evaluate(state);
    if (open_goals < root.open_goals) {
        commit(make_root(state, open_goals));
        return;
    }
    std::uint32_t* record = records.next();
    std::copy_n(before, 1 + words_, record);
    for (const GroundEffect& effect : task_.effects[op.index()]) {
        if (state[static_cast<std::size_t>(effect.fact.variable)] != effect.fact.value) continue;
        const std::uint32_t fact = task_.fact_number(effect.fact);
        const auto place = std::ranges::lower_bound(root.facts, fact);
        if (place == root.facts.end() || *place != fact) continue;
        const auto bit = static_cast<std::size_t>(place - root.facts.begin());
        record[1 + bit / 32] |= std::uint32_t{1} << (bit % 32);
    }
    records.commit();
}

Estimate RelaxedCounterEvaluator::evaluate(StateView) {
    spent_ = std::exchange(pending_, 0);
    const std::uint32_t* record = (*records_)[at_.index()];
    if (roots_[record[0]].dead_end) return kDeadEnd;
    int count = 0;
    for (std::size_t i = 0; i < words_; ++i) count += std::popcount(record[1 + i]);
    return count;
}

}  // namespace praxis
