#include "belief/cases.hpp"

#include <cstring>
#include <string_view>
#include <unordered_set>

namespace praxis::belief {

Cases::Cases(const BeliefTask& task, const Components& components, const Component& component)
    : task_(&task),
      components_(&components),
      component_(static_cast<std::uint32_t>(&component - components.tracked.data())),
      width_(component.variables.size()),
      count_(component.count()),
      rows_(component.cases) {
    finish();
}

bool Cases::keep(std::size_t column, std::int32_t value) {
    if (exception(column, 1 - value) == count_) return false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
        if (row(i)[column] != value) continue;
        if (kept != i) std::memcpy(rows_.data() + kept * width_, row(i), width_);
        ++kept;
    }
    count_ = kept;
    rows_.resize(kept * width_);
    finish();
    return true;
}

void Cases::unite(const Cases& other) {
    rows_.insert(rows_.end(), other.rows_.begin(), other.rows_.end());
    count_ += other.count_;
    finish();
}

std::size_t Cases::exception(std::size_t column, std::int32_t value) const {
    std::size_t i = 0;
    while (i < count_ && row(i)[column] == value) ++i;
    return i;
}

void Cases::finish() {
    remove_repeated();
    common_.assign(width_, BeliefTask::kUnknown);
    for (std::size_t column = 0; column < width_; ++column) {
        const std::int32_t first = row(0)[column];
        if (exception(column, first) == count_) common_[column] = first;
    }
}

void Cases::remove_repeated() {
    std::unordered_set<std::string_view> seen;
    std::vector<std::int8_t> rows;
    rows.reserve(rows_.size());
    for (std::size_t i = 0; i < count_; ++i) {
        const std::string_view text(reinterpret_cast<const char*>(row(i)), width_);
        if (seen.insert(text).second) rows.insert(rows.end(), row(i), row(i) + width_);
    }
    count_ = rows.size() / width_;
    rows_ = std::move(rows);
}

}  // namespace praxis::belief
