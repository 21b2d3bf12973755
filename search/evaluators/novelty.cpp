#include "search/evaluators/novelty.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace praxis {

NoveltyEvaluator::NoveltyEvaluator(const FiniteDomainTask& task, const NoveltyOptions& options)
    : task_(task), options_(options), seen_(task.variable_count(), 0) {
    const std::size_t facts = task.fact_count();
    const std::size_t limit = std::max<std::size_t>(options.memory * 8, facts + 64);
    if (options.width >= 2)
        pair_bits_ = std::max<std::size_t>(std::min(facts * (facts + 1) / 2, limit - facts), 1);
    most_tables_ = std::max<std::size_t>(limit / (facts + pair_bits_ + 1), 1);
}

void NoveltyEvaluator::start(StateId, StateView state) {
    changed_.resize(state.size());
    std::iota(changed_.begin(), changed_.end(), 0);
}

void NoveltyEvaluator::follow(StateId, OperatorId op, StateId, StateView state) {
    changed_.clear();
    for (const GroundEffect& effect : task_.effects[op.index()]) {
        if (state[static_cast<std::size_t>(effect.fact.variable)] == effect.fact.value)
            changed_.push_back(effect.fact.variable);
    }
}

Estimate NoveltyEvaluator::evaluate(StateView state) {
    if (options_.forget) forget_on_progress();
    if (++stamp_ == 0) {
        std::ranges::fill(seen_, 0u);
        stamp_ = 1;
    }
    facts_.clear();
    const auto add_fact = [&](std::int32_t variable) {
        const auto index = static_cast<std::size_t>(variable);
        if (seen_[index] == stamp_) return;
        seen_[index] = stamp_;
        facts_.push_back(task_.fact_number({variable, state[index]}));
    };
    for (const std::int32_t variable : changed_) add_fact(variable);
    const std::size_t changed = facts_.size();
    Table& bits = table();
    Estimate result = options_.width + 1;
    for (std::size_t i = 0; i < changed; ++i) {
        if (add(bits, facts_[i])) result = 1;
    }
    if (options_.width == 1) return result;
    for (std::int32_t variable = 0; variable < static_cast<std::int32_t>(state.size()); ++variable)
        add_fact(variable);
    bool new_pair = false;
    for (std::size_t i = 0; i < changed; ++i) {
        for (std::size_t j = i + 1; j < facts_.size(); ++j)
            new_pair |= add(bits, pair_bit(facts_[i], facts_[j]));
    }
    return new_pair ? std::min(result, Estimate{2}) : result;
}

std::size_t NoveltyEvaluator::pair_bit(std::uint32_t a, std::uint32_t b) const {
    const std::size_t low = std::min(a, b);
    const std::size_t high = std::max(a, b);
    std::size_t bit = high * (high + 1) / 2 + low;
    if (bit >= pair_bits_) bit = (bit * 0x9e3779b97f4a7c15u >> 20) % pair_bits_;
    return task_.fact_count() + bit;
}

NoveltyEvaluator::Table& NoveltyEvaluator::table() {
    const auto [place, added] = numbers_.try_emplace(partition_, 0);
    if (added) {
        if (tables_.size() < most_tables_) {
            place->second = tables_.size();
            tables_.emplace_back((task_.fact_count() + pair_bits_ + 63) / 64, 0u);
        } else {
            std::uint64_t hash = 0;
            for (const std::int64_t value : partition_)
                hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15u;
            place->second = (hash >> 20) % tables_.size();
        }
    }
    return tables_[place->second];
}

void NoveltyEvaluator::forget_on_progress() {
    if (best_.empty()) best_.assign(partition_.size(), std::numeric_limits<std::int64_t>::max());
    bool progress = false;
    for (std::size_t i = 0; i < partition_.size(); ++i) {
        if (partition_[i] >= best_[i]) continue;
        best_[i] = partition_[i];
        progress = true;
    }
    if (!progress) return;
    tables_.clear();
    numbers_.clear();
}

bool NoveltyEvaluator::add(Table& table, std::size_t bit) {
    std::uint64_t& word = table[bit / 64];
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    const bool fresh = (word & mask) == 0;
    word |= mask;
    return fresh;
}

}  // namespace praxis
