// The states one search has met, each stored once, with the search's own data beside it.
//
// A record is `node_words` words that belong to the search (parent, cost, ...) and the packed state, next to
// each other because they are read together. States are numbered in the order of discovery. A new state is
// written straight into the next free record; if it turns out to be known, the record is used again for the
// next one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "search/state/ids.hpp"
#include "search/state/record_pool.hpp"
#include "search/state/state_packer.hpp"
#include "search/state/state_set.hpp"

namespace praxis {

class StateRegistry {
  public:
    StateRegistry(const StatePacker& packer, std::size_t node_words)
        : words_(packer.word_count()), node_words_(node_words), pool_(words_ + node_words) {}

    std::uint32_t size() const { return pool_.size(); }
    const std::uint32_t* words(StateId id) const { return pool_[id.index()] + node_words_; }
    std::uint32_t* node(StateId id) { return pool_[id.index()]; }
    const std::uint32_t* node(StateId id) const { return pool_[id.index()]; }

    /// Where the next state is to be written before `intern`.
    std::uint32_t* candidate() { return pool_.next() + node_words_; }
    /// A candidate that starts as a copy of a stored state.
    std::uint32_t* candidate_from(StateId id) {
        std::uint32_t* copy = candidate();
        std::copy_n(words(id), words_, copy);
        return copy;
    }
    /// Stores the candidate unless an equal state is there; its id and whether it is new. The node words of a
    /// new state are unspecified.
    std::pair<StateId, bool> intern() { return intern(candidate(), hash(candidate())); }
    /// The same for a packed state elsewhere and its hash.
    std::pair<StateId, bool> intern(const std::uint32_t* words, std::uint64_t hash_value) {
        const auto [id, added] = set_.insert(
            hash_value, pool_.size(),
            [&](std::uint32_t other) { return equal(words, pool_[other] + node_words_); },
            [&](std::uint32_t other) { return hash(pool_[other] + node_words_); },
            [&](std::uint32_t other) { __builtin_prefetch(pool_[other]); });
        if (added) {
            if (words != candidate()) std::copy_n(words, words_, candidate());
            pool_.commit();
        }
        return {StateId(id), added};
    }

    std::size_t word_count() const { return words_; }
    std::uint64_t hash(const std::uint32_t* words) const { return hash_words(words, words_); }
    /// Brings the part of the set where a hash belongs into the cache.
    void prefetch_place(std::uint64_t hash_value) const { set_.prefetch(hash_value); }
    /// Then, a little later: brings the state that may be equal into the cache.
    void prefetch_state(std::uint64_t hash_value) const {
        const std::uint32_t id = set_.likely(hash_value);
        if (id != StateSet::kNone) __builtin_prefetch(pool_[id]);
    }

    /// The candidate is equal to a stored state.
    bool candidate_equals(StateId id) { return equal(words(id), candidate()); }
    /// Bytes a stored state takes, room that is allocated ahead in the pool left out.
    double bytes_per_state() const {
        return static_cast<double>(pool_.stride() * sizeof(std::uint32_t)) +
               static_cast<double>(set_.memory()) / std::max(1.0, static_cast<double>(size()));
    }
    /// Bytes on the heap.
    std::size_t memory() const { return pool_.memory() + set_.memory(); }

  private:
    // Packed states are short: a loop beats a call of memcmp.
    bool equal(const std::uint32_t* a, const std::uint32_t* b) const {
        for (std::size_t i = 0; i < words_; ++i) {
            if (a[i] != b[i]) return false;
        }
        return true;
    }

    std::size_t words_;
    std::size_t node_words_;
    RecordPool pool_;
    StateSet set_;
};

}  // namespace praxis
