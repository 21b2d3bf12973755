// Where the atoms of the lifted task are in the ground task.
//
// An atom is a *fact* (or several, one a variable), *constant* (true in every reachable state: a static atom,
// or a fluent one that nothing deletes), or *absent* (in no reachable state). For derived atoms that are not
// facts the ground task does not say which of the two; ask `of_derived` predicates with care.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "parser/task.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Made from the lifted task that was grounded (without pruning) and the ground task. Refers to neither
/// afterwards.
class AtomIndex {
  public:
    AtomIndex(const LiftedTask& lifted, const FiniteDomainTask& ground);

    struct Entry {
        enum class Kind : std::uint8_t { fact, constant_fluent, constant_static };
        Kind kind = Kind::fact;
        Fact fact;                     ///< kind `fact`
        std::uint32_t next = kAbsent;  ///< the same atom in another variable
    };
    static constexpr std::uint32_t kAbsent = 0xffffffff;

    /// The number of the atom's first entry, or kAbsent.
    std::uint32_t find(PredicateId predicate, std::span<const ObjectId> arguments) const;
    const Entry& operator[](std::uint32_t number) const { return entries_[number]; }
    std::size_t size() const { return entries_.size(); }

    /// How many fluent atoms are constant: a state without all of them is none of this ground task.
    std::size_t constant_fluents() const { return constant_fluents_; }
    /// By variable: the value where none of its atoms holds, or -1.
    const std::vector<std::int32_t>& empty_values() const { return empty_values_; }
    /// By fact number: the mutex groups it is in.
    const PackedLists<std::uint32_t>& groups_of() const { return groups_of_; }

  private:
    std::uint64_t hash(std::span<const std::uint32_t> key) const;
    void insert(std::span<const std::uint32_t> key, Entry entry);
    std::uint32_t find(std::span<const std::uint32_t> key) const;
    void grow();
    void add_facts(const LiftedTask& lifted, const FiniteDomainTask& ground);
    void add_constants(const LiftedTask& lifted);
    void add_groups(const FiniteDomainTask& ground);

    std::vector<Entry> entries_;
    PackedLists<std::uint32_t> keys_;   ///< by entry: predicate, objects
    std::vector<std::uint32_t> slots_;  ///< open addressing; entry number or kAbsent
    std::vector<std::int32_t> empty_values_;
    PackedLists<std::uint32_t> groups_of_;
    std::size_t constant_fluents_ = 0;
};

}  // namespace praxis
