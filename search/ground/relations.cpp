#include "search/ground/relations.hpp"

#include <algorithm>

namespace praxis::grounding {
namespace {

constexpr std::size_t kLargestDenseTable = std::size_t{1} << 20;
constexpr std::size_t kAllDenseTables = std::size_t{1} << 23;

}  // namespace

Relations::Relations(const LiftedTask& task, const Budget& budget)
    : task_(task), budget_(budget), positions_(task.types.size()), dense_budget_(kAllDenseTables) {
    for (std::size_t p = 0; p < task.predicates.size(); ++p) {
        const RelationId id = add(task.predicates[p].parameters, true);
        const Relation& initial = task.initial_atoms[p];
        std::vector<Object> tuple(initial.arity);
        for (std::size_t i = 0; i < initial.count; ++i) {
            const auto arguments = initial.tuple(i);
            for (std::size_t c = 0; c < tuple.size(); ++c) {
                tuple[c] = arguments[c].index();
                if (column_types_[id][c].valid() &&
                    !task.types[task.predicates[p].parameters[c].index()].contains[tuple[c]])
                    distrust(id, c);
            }
            stores_[id].insert(tuple.data());
        }
    }
}

bool Relations::look_at_budget() const {
    if (budget_.exhausted() != Stop::none) {
        ticks_ = 1;
        return false;
    }
    ticks_ = 4096;
    return true;
}

std::vector<ColumnRange> Relations::ranges(std::span<const TypeId> columns) {
    std::vector<ColumnRange> result;
    for (TypeId type : columns) {
        std::vector<std::uint32_t>& position = positions_[type.index()];
        const auto& objects = task_.types[type.index()].objects;
        if (position.empty()) {
            position.assign(task_.objects.size(), kNoRow);
            for (std::size_t i = 0; i < objects.size(); ++i)
                position[objects[i].index()] = static_cast<std::uint32_t>(i);
        }
        result.push_back({&position, static_cast<std::uint32_t>(objects.size())});
    }
    return result;
}

RelationId Relations::add(std::span<const TypeId> columns, bool findable) {
    const std::size_t limit = findable ? std::min(kLargestDenseTable, dense_budget_) : 0;
    stores_.emplace_back(ranges(columns), limit);
    dense_budget_ -= stores_.back().dense_entries();
    column_types_.emplace_back(columns.begin(), columns.end());
    return static_cast<RelationId>(stores_.size() - 1);
}

bool Relations::column_within(RelationId relation, std::size_t column, TypeId type) const {
    const TypeId declared = column_types_[relation][column];
    return declared.valid() && within(declared, type);
}

void Relations::distrust(RelationId relation, std::size_t column) {
    column_types_[relation][column] = TypeId();
}

bool Relations::within(TypeId inner, TypeId outer) const {
    if (inner == outer || outer.index() == 0) return true;
    const auto [found, fresh] = within_.try_emplace({inner, outer}, false);
    if (fresh) {
        const auto& objects = task_.types[inner.index()].objects;
        const auto& contains = task_.types[outer.index()].contains;
        found->second = std::all_of(objects.begin(), objects.end(),
                                    [&](ObjectId object) { return contains[object.index()]; });
    }
    return found->second;
}

}  // namespace praxis::grounding
