#include "belief/cases.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>
#include <unordered_set>
#include <utility>

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

std::vector<Cases::Change> Cases::changes(std::uint32_t action, const Way& way) const {
    const auto effects = task_->physical->effects[action];
    std::vector<Change> result;
    for (std::size_t e = 0; e < effects.size(); ++e)
        if (const std::uint32_t column = column_of(effects[e].fact.variable);
            column != Components::kNone && way[e])
            result.push_back({column, static_cast<std::int8_t>(effects[e].fact.value), effects[e].condition});
    return result;
}

void Cases::act(std::uint32_t action, std::span<const Way> ways) {
    std::vector<std::vector<Change>> outcomes;
    for (const Way& way : ways)
        if (std::vector<Change> outcome = changes(action, way);
            std::find(outcomes.begin(), outcomes.end(), outcome) == outcomes.end())
            outcomes.push_back(std::move(outcome));
    const bool opens = !task_->forgotten[action].empty();
    if (outcomes.size() == 1 && outcomes.front().empty() && !opens) return;
    std::vector<std::int8_t> rows;
    rows.reserve(rows_.size() * outcomes.size());
    for (const std::vector<Change>& outcome : outcomes) {
        for (std::size_t i = 0; i < count_; ++i) {
            const std::int8_t* const before = row(i);
            std::int8_t* const values = &*rows.insert(rows.end(), before, before + width_);
            for (const Change& change : outcome) {
                const auto condition = task_->physical->conditions[change.condition];
                if (std::all_of(condition.begin(), condition.end(), [&](const Fact& fact) {
                        const std::uint32_t column = column_of(fact.variable);
                        return column == Components::kNone || before[column] == fact.value;
                    }))
                    values[change.column] = change.value;
            }
        }
    }
    rows_ = std::move(rows);
    count_ = rows_.size() / width_;
    if (opens) open_choices(action);
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

void Cases::open_choices(std::uint32_t action) {
    const auto forgotten = task_->forgotten[action];
    const auto own = [&](std::int32_t variable) {
        return components_->component_of[static_cast<std::size_t>(variable)] == component_;
    };
    const auto column = [&](std::int32_t variable) {
        return components_->column_of[static_cast<std::size_t>(variable)];
    };
    for (std::size_t c = 0; c < task_->choices.size(); ++c) {
        const auto choice = task_->choices[c];
        const std::int32_t first = choice.front().variable;
        if (!own(first) || std::find(forgotten.begin(), forgotten.end(), first) == forgotten.end()) continue;
        std::vector<std::int8_t> rows;
        rows.reserve(rows_.size() * choice.size());
        for (std::size_t i = 0; i < count_; ++i) {
            for (const Fact& chosen : choice) {
                std::int8_t* const values = &*rows.insert(rows.end(), row(i), row(i) + width_);
                for (const Fact& fact : choice)
                    values[column(fact.variable)] =
                        static_cast<std::int8_t>(fact == chosen ? fact.value : 1 - fact.value);
            }
        }
        rows_ = std::move(rows);
        count_ = rows_.size() / width_;
        remove_repeated();
    }
    for (const GroundDefinition& definition : task_->definitions) {
        const Fact defined = definition.fact;
        if (!own(defined.variable) ||
            std::find(forgotten.begin(), forgotten.end(), defined.variable) == forgotten.end())
            continue;
        for (std::size_t i = 0; i < count_; ++i) {
            std::int8_t* const values = rows_.data() + i * width_;
            const bool holds =
                std::any_of(definition.condition.terms().begin(), definition.condition.terms().end(),
                            [&](const Dnf::Term& term) {
                                return std::all_of(term.begin(), term.end(), [&](const Fact& fact) {
                                    return values[column(fact.variable)] == fact.value;
                                });
                            });
            values[column(defined.variable)] =
                static_cast<std::int8_t>(holds ? defined.value : 1 - defined.value);
        }
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
