#include "belief/hypotheses.hpp"

#include <algorithm>
#include <iterator>
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

void Hypotheses::allow(std::uint32_t action, const KnownBeside& beside) {
    std::vector<Row> left;
    for (const Row& row : rows_)
        if (hypothesis(row, beside).allows(action)) left.push_back(row);
    if (!left.empty()) rows_ = std::move(left);
}

void Hypotheses::act(std::uint32_t action, std::span<const std::int32_t> variables,
                     const KnownBeside& beside) {
    if (empty()) return;
    add(variables, beside);
    for (Row& row : rows_) row = after(action, row, beside);
    remove_repeated();
}

void Hypotheses::fail(std::uint32_t action, std::span<const std::int32_t> variables,
                      const KnownBeside& beside) {
    add(variables, beside);
    std::vector<Row> impossible, unchanged, changed;
    for (Row& row : rows_) {
        const bool allowed = hypothesis(row, beside).allows(action);
        if (allowed) changed.push_back(after(action, row, beside));
        (allowed ? unchanged : impossible).push_back(std::move(row));
    }
    rows_ = std::move(impossible);
    for (std::vector<Row>* rows : {&unchanged, &changed})
        rows_.insert(rows_.end(), std::make_move_iterator(rows->begin()),
                     std::make_move_iterator(rows->end()));
    remove_repeated();
    if (rows_.size() > kMostHypotheses) rows_.resize(kMostHypotheses);
}

bool Hypotheses::refuse(std::uint32_t action, const KnownBeside& beside) {
    const auto precondition = task_->physical->preconditions[action];
    std::vector<Row> left;
    for (const Row& row : rows_) {
        const Truth possible = hypothesis(row, beside).hold(precondition);
        if (possible == Truth::known_false || (possible == Truth::unknown && &row != &rows_.front()))
            left.push_back(row);
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

void Hypotheses::add(std::span<const std::int32_t> variables, const KnownBeside& beside) {
    for (const std::int32_t variable : variables) {
        if (about(variable)) continue;
        if (empty()) rows_.emplace_back();
        columns_.push_back(variable);
        for (Row& row : rows_) row.push_back(beside(variable));
    }
}

void Hypotheses::remove_repeated() {
    std::vector<Row> rows;
    for (Row& row : rows_)
        if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
    rows_ = std::move(rows);
}

Hypotheses::Row Hypotheses::after(std::uint32_t action, const Row& row, const KnownBeside& beside) {
    Hypothesis before = hypothesis(row, beside);
    Row result = row;
    for (const GroundEffect& effect : task_->physical->effects[action]) {
        const std::size_t c = column(effect.fact.variable);
        if (c == columns_.size()) continue;
        const Truth fires = before.fires(action, effect.condition);
        if (fires == Truth::known_true)
            result[c] = effect.fact.value;
        else if (fires == Truth::unknown && result[c] != effect.fact.value)
            result[c] = BeliefTask::kUnknown;
    }
    for (const std::int32_t variable : task_->forgotten[action])
        if (about(variable)) result[column(variable)] = BeliefTask::kUnknown;
    return result;
}

}  // namespace praxis::belief
