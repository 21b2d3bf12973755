// A relation that is filled without duplicates.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "parser/task.hpp"

namespace praxis::check {

/// An index over the tuples of one relation. The relation must outlive it and grow only through it.
class TupleIndex {
  public:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    explicit TupleIndex(Relation& relation) : relation_(&relation) {}

    /// The number of a tuple in the relation, or kNone.
    std::size_t find(std::span<const ObjectId> tuple) const;

    /// Appends a tuple unless it is there; returns its number.
    std::size_t insert(std::span<const ObjectId> tuple);

  private:
    std::size_t slot_of(std::span<const ObjectId> tuple) const;
    void grow();

    Relation* relation_;
    std::vector<std::uint32_t> slots_;  ///< open addressing; number + 1, or 0
};

}  // namespace praxis::check
