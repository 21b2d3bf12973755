#include "belief/hypotheses.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {
namespace {

constexpr std::size_t kMostHypotheses = 256;

}  // namespace

std::size_t Hypotheses::column(std::int32_t variable) const {
    return static_cast<std::size_t>(std::find(columns_.begin(), columns_.end(), variable) - columns_.begin());
}

std::uint64_t Hypotheses::fingerprint() const {
    std::uint64_t result = 0xcbf29ce484222325ULL;
    const auto mix = [&](std::int32_t value) {
        result = (result ^ static_cast<std::uint32_t>(value)) * 0x100000001b3ULL;
    };
    for (const std::int32_t variable : columns_) mix(variable);
    for (const Row& row : rows_)
        for (const std::int32_t value : row) mix(value);
    return result;
}

void Hypotheses::act(const BeliefTask& task, std::uint32_t action, const Value& value) {
    if (empty()) return;
    const auto precondition = task.physical->preconditions[action];
    std::vector<Row> left = rows_;
    std::erase_if(left, [&](const Row& row) { return hold(row, precondition, value) == Truth::known_false; });
    if (!left.empty()) rows_ = std::move(left);
    for (Row& row : rows_) row = after(task, action, row, value);
    remove_repeated();
}

void Hypotheses::fail(const BeliefTask& task, std::uint32_t action, std::span<const std::int32_t> variables,
                      const Value& value) {
    for (const std::int32_t variable : variables) add(variable, value);
    if (empty()) return;
    const auto precondition = task.physical->preconditions[action];
    const auto possible = [&](const Row& row) {
        return hold(row, precondition, value) != Truth::known_false;
    };
    std::stable_partition(rows_.begin(), rows_.end(), [&](const Row& row) { return !possible(row); });
    for (std::size_t i = 0, count = rows_.size(); i < count; ++i)
        if (possible(rows_[i])) rows_.push_back(after(task, action, rows_[i], value));
    remove_repeated();
    if (rows_.size() > kMostHypotheses) rows_.resize(kMostHypotheses);
}

bool Hypotheses::refuse(const BeliefTask& task, std::uint32_t action, const Value& value) {
    const auto precondition = task.physical->preconditions[action];
    // Derived atoms are those of the first hypothesis: of the others they tell nothing.
    const bool derived = std::any_of(precondition.begin(), precondition.end(),
                                     [&](const Fact& fact) { return task.physical->derived(fact.variable); });
    std::vector<Row> left;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Truth possible = hold(rows_[i], precondition, value);
        if (possible == Truth::known_false || (i > 0 && (derived || possible == Truth::unknown)))
            left.push_back(rows_[i]);
    }
    if (left.empty()) return false;
    rows_ = std::move(left);
    return true;
}

void Hypotheses::learn(Fact fact) {
    if (!about(fact.variable)) return;
    const std::size_t c = column(fact.variable);
    Row first = rows_.front();
    first[c] = fact.value;
    std::erase_if(rows_,
                  [&](const Row& row) { return row[c] != fact.value && row[c] != BeliefTask::kUnknown; });
    for (Row& row : rows_) row[c] = fact.value;
    if (rows_.empty()) rows_.push_back(std::move(first));
    remove_repeated();
}

void Hypotheses::turn() {
    if (!empty()) std::rotate(rows_.begin(), rows_.begin() + 1, rows_.end());
}

void Hypotheses::forget(std::int32_t variable) {
    if (!about(variable)) return;
    for (Row& row : rows_) row[column(variable)] = BeliefTask::kUnknown;
    remove_repeated();
}

std::vector<Fact> Hypotheses::settle() {
    std::vector<Fact> agreed;
    for (std::size_t c = columns_.size(); c-- > 0;) {
        const std::int32_t common = rows_.front()[c];
        if (!std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row[c] == common; }))
            continue;
        agreed.push_back({columns_[c], common});
        columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(c));
        for (Row& row : rows_) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
    }
    if (empty()) rows_.clear();
    return agreed;
}

void Hypotheses::add(std::int32_t variable, const Value& value) {
    if (about(variable)) return;
    if (empty()) rows_.emplace_back();
    columns_.push_back(variable);
    for (Row& row : rows_) row.push_back(value(variable));
}

void Hypotheses::remove_repeated() {
    std::vector<Row> rows;
    for (Row& row : rows_)
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
    rows_ = std::move(rows);
}

std::int32_t Hypotheses::value(const Row& row, std::int32_t variable, const Value& value) const {
    const std::size_t c = column(variable);
    return c < columns_.size() ? row[c] : value(variable);
}

Truth Hypotheses::hold(const Row& row, std::span<const Fact> facts, const Value& other) const {
    Truth result = Truth::known_true;
    for (const Fact& fact : facts) {
        const std::int32_t now = value(row, fact.variable, other);
        if (now == BeliefTask::kUnknown)
            result = Truth::unknown;
        else if (now != fact.value)
            return Truth::known_false;
    }
    return result;
}

Hypotheses::Row Hypotheses::after(const BeliefTask& task, std::uint32_t action, const Row& row,
                                  const Value& other) const {
    Row result = row;
    for (const GroundEffect& effect : task.physical->effects[action]) {
        const std::size_t c = column(effect.fact.variable);
        if (c == columns_.size()) continue;
        const Truth fires = hold(row, task.physical->conditions[effect.condition], other);
        if (fires == Truth::known_true)
            result[c] = effect.fact.value;
        else if (fires == Truth::unknown && result[c] != effect.fact.value)
            result[c] = BeliefTask::kUnknown;
    }
    for (const std::int32_t variable : task.forgotten[action])
        if (about(variable)) result[column(variable)] = BeliefTask::kUnknown;
    return result;
}

}  // namespace praxis::belief
