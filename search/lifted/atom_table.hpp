// Ground atoms by number: an atom gets the next number when it is first met.
//
// Lifted search cannot know beforehand which atoms are reachable, so it counts them as they come. An atom is
// kept as its predicate and arguments in one flat array; finding one is a look into an open hash table of
// numbers.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "parser/task.hpp"

namespace praxis::lifted {

using ObjectNumber = std::uint32_t;
using PredicateNumber = std::uint32_t;
using AtomNumber = std::uint32_t;
inline constexpr AtomNumber kNoAtom = std::numeric_limits<AtomNumber>::max();

class AtomTable {
  public:
    explicit AtomTable(const LiftedTask& task);

    std::uint32_t size() const { return static_cast<std::uint32_t>(begin_.size()); }
    PredicateNumber predicate(AtomNumber atom) const { return words_[begin_[atom]]; }
    const ObjectNumber* arguments(AtomNumber atom) const { return words_.data() + begin_[atom] + 1; }
    std::uint32_t arity(PredicateNumber predicate) const { return arities_[predicate]; }

    /// The atom's number, or kNoAtom if it was never met.
    AtomNumber find(PredicateNumber predicate, const ObjectNumber* arguments) const;
    /// The atom's number and whether it is new.
    std::pair<AtomNumber, bool> intern(PredicateNumber predicate, const ObjectNumber* arguments);

    /// Bytes on the heap.
    std::size_t memory() const;

  private:
    std::size_t place(PredicateNumber predicate, const ObjectNumber* arguments) const;
    bool equal(AtomNumber atom, PredicateNumber predicate, const ObjectNumber* arguments) const;
    void grow();

    std::vector<std::uint32_t> arities_;
    std::vector<std::uint32_t> words_;  ///< predicate, arguments; one atom after the other
    std::vector<std::uint32_t> begin_;
    std::vector<std::uint32_t> slots_;  ///< atom + 1; a power of two
};

}  // namespace praxis::lifted
