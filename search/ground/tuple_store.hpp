// A growing relation of object tuples: rows in insertion order, a duplicate set, and indices for joins.
//
// Rows are numbered 0, 1, ... in insertion order and never move or go. Finding a tuple takes one look into a
// dense table when the product of the column ranges is small, a hash look-up otherwise. An *index* lists the
// rows with given values in some columns; it covers rows 0..indexed()-1: rows are inserted at once but become
// visible to joins only when the caller says so (`publish`), which is what makes semi-naive evaluation derive
// everything once.
//
// Memory: 4 bytes a column, 4-8 bytes a row for the duplicate set, 4 bytes a row and index.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace praxis::grounding {

using Object = std::uint32_t;
using Row = std::uint32_t;
inline constexpr Row kNoRow = std::numeric_limits<Row>::max();

/// What values a column takes: position_of[object] < size, or kNoRow for objects that never occur in it.
struct ColumnRange {
    const std::vector<std::uint32_t>* position_of = nullptr;
    std::uint32_t size = 0;
};

class TupleStore {
  public:
    /// `dense_limit`: largest table of 4-byte entries the store may use for finding tuples.
    TupleStore(std::span<const ColumnRange> columns, std::size_t dense_limit);

    std::uint32_t arity() const { return arity_; }
    Row size() const { return count_; }
    Row published() const { return published_; }
    const Object* row(Row i) const { return rows_.data() + std::size_t{i} * arity_; }
    /// Entries of the dense table (0: hashed).
    std::size_t dense_entries() const { return dense_.size(); }

    /// The tuple's row, or kNoRow.
    Row find(const Object* tuple) const;
    /// The tuple's row, and whether it is new.
    std::pair<Row, bool> insert(const Object* tuple);
    /// Adds a tuple that is known to be new and that nobody will look for.
    void append(const Object* tuple);

    /// Makes rows up to `end` visible to joins.
    void publish(Row end);

    /// The number of an index over `columns` (increasing, not empty), made if there is none.
    std::uint32_t index_on(std::span<const std::uint32_t> columns);
    /// The newest published row with these values in the index's columns, or kNoRow; `next_in` goes on.
    Row first_in(std::uint32_t index, const Object* key) const;
    Row next_in(std::uint32_t index, Row row) const { return indices_[index].next[row]; }
    /// How many different keys an index over one column holds (an estimate before anything is published).
    std::size_t distinct(std::uint32_t column) const;

  private:
    struct Index {
        std::vector<std::uint32_t> columns;
        std::vector<Row> heads;  ///< one column: by object; more: hash slots
        std::vector<Row> next;
        std::size_t keys = 0;
    };

    std::size_t dense_address(const Object* tuple) const;
    std::size_t hash(const Object* tuple) const;
    void grow_slots();
    void leave_dense();
    void add_to(Index& index, Row row);
    void grow(Index& index);
    std::size_t key_hash(const Index& index, Row row) const;

    std::uint32_t arity_;
    Row count_ = 0;
    Row published_ = 0;
    std::vector<Object> rows_;
    std::vector<ColumnRange> columns_;
    std::vector<Row> dense_;  ///< row + 1 by address
    std::vector<Row> slots_;  ///< row + 1; a power of two
    bool use_dense_ = false;
    std::vector<Index> indices_;
    mutable std::vector<std::pair<Row, std::size_t>> distinct_;  ///< by column: rows seen, values
    mutable std::vector<std::vector<bool>> seen_values_;
};

}  // namespace praxis::grounding
