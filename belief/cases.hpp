// The cases of one component that are still possible, exactly.
#pragma once

#include <cstdint>
#include <span>
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

    /// By effect of an action: the facts of no component in its condition hold.
    using Way = std::vector<bool>;
    /// Applies an action to every case, in each of the ways.
    void act(std::uint32_t action, std::span<const Way> ways);
    /// Leaves the cases in which the column has the value; false, and nothing changes, if there are none.
    bool keep(std::size_t column, std::int32_t value);
    /// The cases of both are possible.
    void unite(const Cases& other);
    /// A case in which the column does not have the value; `count()` if there is none.
    std::size_t exception(std::size_t column, std::int32_t value) const;

  private:
    struct Change {
        std::uint32_t column;
        std::int8_t value;
        std::uint32_t condition;
        bool operator==(const Change&) const = default;
    };

    std::uint32_t column_of(std::int32_t variable) const {
        return components_->component_of[index(variable)] == component_
                   ? components_->column_of[index(variable)]
                   : Components::kNone;
    }
    std::vector<Change> changes(std::uint32_t action, const Way& way) const;
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
};

}  // namespace praxis::belief
