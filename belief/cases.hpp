// The cases of one component that are still possible, exactly.
#pragma once

#include <cstdint>
#include <vector>

#include "belief/components.hpp"

namespace praxis::belief {

class Cases {
  public:
    /// Refers to the task.
    Cases(const BeliefTask& task, const Components& components, const Component& component);

    std::size_t count() const { return count_; }
    std::size_t width() const { return width_; }
    const std::int8_t* row(std::size_t i) const { return rows_.data() + i * width_; }

    /// The value of a column in all cases, or BeliefTask::kUnknown.
    std::int32_t value(std::size_t column) const { return common_[column]; }

    /// Applies an action to every case. `certain(fact)` says whether a fact of no component holds.
    template <class Certain>
    void act(std::uint32_t action, const Certain& certain);
    /// Leaves the cases in which the column has the value; false, and nothing changes, if there are none.
    bool keep(std::size_t column, std::int32_t value);
    /// The cases of both are possible.
    void unite(const Cases& other);
    /// A case in which the column does not have the value; `count()` if there is none.
    std::size_t exception(std::size_t column, std::int32_t value) const;

  private:
    void finish();
    void remove_repeated();
    /// Multi-valued variables that the action leaves open: every case with each of their values.
    void open_choices(std::uint32_t action);

    const BeliefTask* task_;
    const Components* components_;
    std::uint32_t component_;
    std::size_t width_;
    std::size_t count_ = 0;
    std::vector<std::int8_t> rows_;
    std::vector<std::int32_t> common_;
    std::vector<std::int8_t> before_;
};

template <class Certain>
void Cases::act(std::uint32_t action, const Certain& certain) {
    const FiniteDomainTask& task = *task_->physical;
    struct Change {
        std::uint32_t column;
        std::int8_t value;
        std::uint32_t condition;
    };
    std::vector<Change> changes;
    const auto column_of = [&](std::int32_t variable) -> std::uint32_t {
        const auto v = static_cast<std::size_t>(variable);
        return components_->component_of[v] == component_ ? components_->column_of[v] : Components::kNone;
    };
    for (const GroundEffect& effect : task.effects[action]) {
        const std::uint32_t column = column_of(effect.fact.variable);
        if (column == Components::kNone) continue;
        bool possible = true;
        for (const Fact& fact : task.conditions[effect.condition])
            possible = possible && (column_of(fact.variable) != Components::kNone || certain(fact));
        if (possible)
            changes.push_back({column, static_cast<std::int8_t>(effect.fact.value), effect.condition});
    }
    const bool opens = !task_->forgotten[action].empty();
    if (changes.empty() && !opens) return;
    for (std::size_t i = 0; i < count_; ++i) {
        std::int8_t* const values = rows_.data() + i * width_;
        before_.assign(values, values + width_);
        for (const Change& change : changes) {
            bool fires = true;
            for (const Fact& fact : task.conditions[change.condition]) {
                const std::uint32_t column = column_of(fact.variable);
                fires = fires && (column == Components::kNone || before_[column] == fact.value);
            }
            if (fires) values[change.column] = change.value;
        }
    }
    if (opens) open_choices(action);
    finish();
}

}  // namespace praxis::belief
