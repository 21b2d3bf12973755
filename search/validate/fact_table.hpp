// The tuples of one predicate in the state at hand, with indexes for joins.
//
// A *row* is a tuple that has been seen; rows are interned once and are *alive* while the tuple holds.
// Killing or reviving a row touches no index, and clearing the table is one increment of its epoch. An index
// on a set of argument positions (a bit mask) is built when first asked for and chains the rows that agree
// there; rows may be inserted while a chain is walked. Dead rows are skipped by the walker and are thrown out
// by `compact` once they dominate. Rows and objects are 32-bit.
#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <span>
#include <vector>

namespace praxis::validation {

class FactTable {
  public:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    /// The rows that agree on the positions of a mask: the first of the chain and how many (dead ones
    /// included).
    struct Chain {
        std::uint32_t first = kNone;
        std::uint32_t count = 0;
        const std::vector<std::uint32_t>* next = nullptr;
    };

    explicit FactTable(std::uint32_t arity);

    std::uint32_t arity() const { return arity_; }
    /// Tuples that hold.
    std::size_t size() const { return alive_count_; }
    /// Grows with every change; equal versions mean equal contents.
    std::uint64_t version() const { return version_; }

    bool contains(const std::uint32_t* tuple) const;
    /// True if the tuple did not hold before.
    bool insert(const std::uint32_t* tuple);
    /// True if the tuple held before.
    bool erase(const std::uint32_t* tuple);
    void clear();
    /// Forgets dead rows if they dominate. Invalidates row numbers and chains.
    void compact();

    std::uint32_t row_count() const { return static_cast<std::uint32_t>(stamps_.size()); }
    bool alive(std::uint32_t row) const { return stamps_[row] == epoch_; }
    const std::uint32_t* row(std::uint32_t row) const {
        return arguments_.data() + row * std::size_t{arity_};
    }
    /// The row of a tuple; kNone if it was never seen.
    std::uint32_t find(const std::uint32_t* tuple) const;

    /// The rows that have the arguments `key[i]` at the positions i in `mask` (not empty; positions below
    /// 32).
    Chain match(std::uint32_t mask, const std::uint32_t* key);

  private:
    struct Index {
        std::uint32_t mask = 0;
        std::vector<std::uint32_t> slots;  ///< bucket numbers by hash, open addressing
        std::vector<std::uint32_t> first;  ///< by bucket
        std::vector<std::uint32_t> count;  ///< by bucket
        std::vector<std::uint32_t> next;   ///< by row
    };

    bool agree(std::uint32_t mask, const std::uint32_t* a, const std::uint32_t* b) const;
    std::size_t hash(std::uint32_t mask, const std::uint32_t* tuple) const;
    std::size_t slot_of(const std::uint32_t* tuple) const;
    std::size_t slot_of(const Index& index, const std::uint32_t* key) const;
    void add_to(Index& index, std::uint32_t row);
    void grow_slots();
    void grow(Index& index);

    std::uint32_t arity_;
    std::uint32_t epoch_ = 1;
    std::size_t alive_count_ = 0;
    std::uint64_t version_ = 0;
    std::vector<std::uint32_t> arguments_;
    std::vector<std::uint32_t> stamps_;  ///< by row: the epoch in which it is alive
    std::vector<std::uint32_t> slots_;
    std::deque<Index> indexes_;  ///< chains point into it
};

}  // namespace praxis::validation
