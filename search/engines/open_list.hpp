// Open lists: what a search may look at next, and in which order.
//
// An entry is what the search wants back: a state (eager search) or a state and the operators to apply in it
// (lazy search, which evaluates a state only when its turn comes and sorts it by its parent's estimates until
// then). Successors that share their place in every list are filed as one entry, and come out one by one.
// An open list is described as data first (OpenListPlan), so that the same description serves both
// kinds of entry.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "search/engines/key.hpp"
#include "search/state/ids.hpp"
#include "search/task/ids.hpp"

namespace praxis {

/// Successors of one state that have not been made yet, by operators that the search has numbered.
struct DeferredEntry {
    StateId parent;
    std::uint32_t first_operator = 0;
    std::uint32_t count = 1;

    bool several() const { return count > 1; }
    /// Takes the first successor away; there must be several.
    DeferredEntry split() {
        --count;
        return {parent, first_operator++, 1};
    }
};

/// How an open list is built.
struct OpenListPlan {
    enum class Kind {
        sorted,       ///< by the keys, the first counting most; first in first out among equals
        alternation,  ///< takes turns among `lists`; lists of preferred entries are boosted on progress
        type_based,   ///< a random entry of a random bucket; the keys say which entries share a bucket
    };
    Kind kind = Kind::sorted;
    std::vector<Key> keys;
    bool preferred_only = false;  ///< takes only entries reached by preferred operators
    bool unsafe_pruning = false;  ///< drops states whose first key is infinite, even if that is no proof
    std::vector<OpenListPlan> lists;
    std::int64_t boost = 0;
    std::uint64_t seed = 0;
};

template <class Entry>
class OpenList {
  public:
    OpenList() = default;
    OpenList(const OpenList&) = delete;
    OpenList& operator=(const OpenList&) = delete;
    virtual ~OpenList() = default;

    /// Files the entry where it belongs; false if no list wanted it.
    virtual bool push(const Evaluated& state, Entry entry) = 0;
    /// One state or successor. Must not be empty.
    virtual Entry pop() = 0;
    virtual bool empty() const = 0;
    /// The search has made progress.
    virtual void boost() {}
    /// Every list would refuse the state because its estimates say that it is a dead end (not necessarily a
    /// proof).
    virtual bool dead_end(const Evaluated& state) const = 0;
};

/// Entry is StateId or DeferredEntry.
template <class Entry>
std::unique_ptr<OpenList<Entry>> make_open_list(const OpenListPlan& plan);

/// Some key of the list uses g.
bool uses_g(const OpenListPlan& plan);
/// The numbers of the heuristics in its keys, each once, in increasing order.
std::vector<std::size_t> heuristics_of(const OpenListPlan& plan);

}  // namespace praxis
