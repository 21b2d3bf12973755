// A view: the tuples of one relation that fit one place in a query, with an index on each column.
//
// Where a query says bond(?c, ?h) with ?c a carbon and ?h a hydrogen, its view keeps only such bonds, and of
// each only the values of the variables; constants and repeated variables are checked when a tuple comes in.
// So joins compare nothing twice, and the sizes that they choose by are those that matter. Views are emptied
// and filled again for every state: an index is an array by object whose entries count only if they bear the
// stamp of the present filling, and it is made when first asked for.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "search/lifted/atom_table.hpp"

namespace praxis::lifted {

class View {
  public:
    using Row = std::uint32_t;
    static constexpr Row kNoRow = std::numeric_limits<Row>::max();

    View(std::uint32_t width, std::size_t object_count)
        : width_(width), object_count_(object_count), indices_(width) {}

    std::uint32_t width() const { return width_; }
    Row size() const { return size_; }
    const ObjectNumber* row(Row i) const { return rows_.data() + std::size_t{i} * width_; }

    void clear() {
        size_ = 0;
        rows_.clear();
        ++stamp_;
    }
    /// Adds a row whose values are written at the place returned.
    ObjectNumber* append() {
        rows_.resize(rows_.size() + width_);
        return rows_.data() + std::size_t{size_++} * width_;
    }

    /// How many rows have the object in the column.
    Row count(std::uint32_t column, ObjectNumber object) {
        const Entry& entry = indexed(column).entries[object];
        return entry.stamp == stamp_ ? entry.count : 0;
    }
    /// The first of them, for an object of which there is one; kNoRow ends `next`.
    Row first(std::uint32_t column, ObjectNumber object) { return indexed(column).entries[object].head; }
    Row next(std::uint32_t column, Row row) const { return indices_[column].next[row]; }

  private:
    struct Entry {
        std::uint32_t stamp = 0;
        Row head = kNoRow;
        Row count = 0;
    };
    struct Index {
        std::uint32_t stamp = 0;
        Row covered = 0;
        std::vector<Entry> entries;
        std::vector<Row> next;
    };

    Index& indexed(std::uint32_t column) {
        Index& index = indices_[column];
        if (index.stamp != stamp_ || index.covered != size_) cover(index, column);
        return index;
    }
    void cover(Index& index, std::uint32_t column);

    std::uint32_t width_;
    std::size_t object_count_;
    Row size_ = 0;
    std::uint32_t stamp_ = 1;
    std::vector<ObjectNumber> rows_;
    std::vector<Index> indices_;
};

}  // namespace praxis::lifted
