// Many short lists in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace praxis {

/// A list of lists, stored flat: list i is items[begin[i] .. begin[i+1]). Append-only.
template <class T>
class PackedLists {
  public:
    PackedLists() : begin_{0} {}

    std::size_t size() const { return begin_.size() - 1; }
    std::size_t total() const { return items_.size(); }
    std::span<const T> operator[](std::size_t i) const {
        return {items_.data() + begin_[i], items_.data() + begin_[i + 1]};
    }
    /// The place of list i's first item in `items()`.
    std::uint32_t begin_of(std::size_t i) const { return begin_[i]; }
    const std::vector<T>& items() const { return items_; }

    /// Adds an item to the list that `close` ends.
    void add(T item) { items_.push_back(std::move(item)); }
    /// Ends the current list; the next `add` begins another.
    void close() { begin_.push_back(static_cast<std::uint32_t>(items_.size())); }
    /// Adds a whole list.
    template <class Range>
    void append(const Range& range) {
        items_.insert(items_.end(), std::begin(range), std::end(range));
        close();
    }
    void reserve(std::size_t lists, std::size_t items) {
        begin_.reserve(lists + 1);
        items_.reserve(items);
    }
    void shrink_to_fit() {
        begin_.shrink_to_fit();
        items_.shrink_to_fit();
    }

  private:
    std::vector<std::uint32_t> begin_;
    std::vector<T> items_;
};

}  // namespace praxis
