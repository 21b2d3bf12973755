#include "search/evaluators/novelty.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace praxis {

namespace {

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    hash = (hash ^ value) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 29;
}

}  // namespace

NoveltyEvaluator::NoveltyEvaluator(const FiniteDomainTask& task, const NoveltyOptions& options)
    : task_(task), options_(options), seen_(task.variable_count(), 0) {
    const std::size_t facts = task.fact_count();
    const std::size_t limit = std::max<std::size_t>(options.memory * 8, 64);
    table_bits_ = facts + (options.width >= 2 ? facts * (facts + 1) / 2 : 0);
    hashed_ = table_bits_ > std::min(options.largest_table, limit);
    most_tables_ = limit / std::max<std::size_t>(table_bits_, 1);
    if (hashed_) bits_.resize(std::min(limit, table_bits_ * 16) / 64 + 1, 0u);
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
    enter_partition();
    Estimate result = options_.width + 1;
    for (std::size_t i = 0; i < changed; ++i) {
        if (add(single_bit(facts_[i]))) result = 1;
    }
    if (options_.width == 1) return result;
    for (std::int32_t variable = 0; variable < static_cast<std::int32_t>(state.size()); ++variable)
        add_fact(variable);
    const std::size_t step = changed * facts_.size() / options_.sample + 1;
    turn_ = step == 1 ? 0 : (turn_ + 1) % step;
    looks_ = changed * (facts_.size() / step);
    bool new_pair = false;
    for (std::size_t i = 0; i < changed; ++i) {
        for (std::size_t j = i + 1 + turn_; j < facts_.size(); j += step)
            new_pair |= add(pair_bit(facts_[i], facts_[j]));
    }
    return new_pair ? std::min(result, Estimate{2}) : result;
}

std::uint64_t NoveltyEvaluator::row(std::uint64_t fact) const {
    return mix(base_, fact) % (bits_.size() * 64);
}

std::size_t NoveltyEvaluator::single_bit(std::uint32_t fact) const {
    return hashed_ ? row(std::uint64_t{fact} << 32) : base_ + fact;
}

std::size_t NoveltyEvaluator::pair_bit(std::uint32_t a, std::uint32_t b) const {
    const std::size_t low = std::min(a, b);
    const std::size_t high = std::max(a, b);
    if (!hashed_) return base_ + task_.fact_count() + high * (high + 1) / 2 + low;
    const std::size_t bit = row(high) + low;
    return bit < bits_.size() * 64 ? bit : bit - bits_.size() * 64;
}

void NoveltyEvaluator::enter_partition() {
    if (hashed_) {
        if (set_ > bits_.size() * 16) clear();
        base_ = generation_;
        for (const std::int64_t value : partition_) base_ = mix(base_, static_cast<std::uint64_t>(value));
        return;
    }
    const auto [place, added] = numbers_.try_emplace(partition_, numbers_.size());
    base_ = place->second % most_tables_ * table_bits_;
    if (bits_.size() * 64 < base_ + table_bits_) bits_.resize((base_ + table_bits_) / 64 + 1, 0u);
}

void NoveltyEvaluator::clear() {
    if (hashed_) {
        std::ranges::fill(bits_, 0u);
    } else {
        bits_.clear();
    }
    set_ = 0;
    numbers_.clear();
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
    if (hashed_) {
        ++generation_;
    } else {
        clear();
    }
}

bool NoveltyEvaluator::add(std::size_t bit) {
    std::uint64_t& word = bits_[bit / 64];
    const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
    const bool fresh = (word & mask) == 0;
    word |= mask;
    set_ += fresh;
    return fresh;
}

}  // namespace praxis
