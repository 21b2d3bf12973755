// All relations of one grounding: the task's predicates first (relation number = predicate number), then
// helpers.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "parser/task.hpp"
#include "search/budget.hpp"
#include "search/ground/tuple_store.hpp"

namespace praxis::grounding {

using RelationId = std::uint32_t;

class Relations {
  public:
    /// Makes the predicates' relations and fills in the initial atoms, unpublished.
    Relations(const LiftedTask& task, const Budget& budget);
    Relations(const Relations&) = delete;
    Relations& operator=(const Relations&) = delete;

    const LiftedTask& task() const { return task_; }
    /// A helper relation whose columns have these types. `findable`: its tuples will be looked for.
    RelationId add(std::span<const TypeId> columns, bool findable);

    std::size_t size() const { return stores_.size(); }
    TupleStore& operator[](RelationId id) { return stores_[id]; }
    const TupleStore& operator[](RelationId id) const { return stores_[id]; }

    /// Every object in the relation's column is surely of the type.
    bool column_within(RelationId relation, std::size_t column, TypeId type) const;
    /// Marks that objects outside the declared type of a column may come in.
    void distrust(RelationId relation, std::size_t column);
    /// Counts a step of work; false once the budget is exhausted (looked at every few thousand steps).
    bool tick() const { return --ticks_ != 0 || look_at_budget(); }
    const Budget& budget() const { return budget_; }
    /// `inner` is a subset of `outer`.
    bool within(TypeId inner, TypeId outer) const;

  private:
    bool look_at_budget() const;
    std::vector<ColumnRange> ranges(std::span<const TypeId> columns);

    const LiftedTask& task_;
    const Budget& budget_;
    mutable std::uint32_t ticks_ = 1;
    std::deque<TupleStore> stores_;
    std::vector<std::vector<TypeId>> column_types_;      ///< an invalid id: distrusted
    std::vector<std::vector<std::uint32_t>> positions_;  ///< by type, made on demand
    std::size_t dense_budget_;
    mutable std::map<std::pair<TypeId, TypeId>, bool> within_;
};

}  // namespace praxis::grounding
