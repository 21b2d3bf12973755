// What engines that are made of other engines hand down to them.
#pragma once

#include <atomic>

#include "search/engines/incumbent.hpp"
#include "search/engines/search.hpp"
#include "search/engines/shared_parts.hpp"

namespace praxis {

struct Call;
class Seat;

/// A bound that several engines share and lower as they find plans.
using SharedBound = std::atomic<std::int64_t>;

struct SearchRun {
    const PreparedTask& prepared;
    const Query& query;
    SharedParts& shared;         ///< of all searches for this query on this task
    const Incumbent& incumbent;  ///< holds the plans that `callbacks.on_plan` was told of
    std::uint64_t seed = 0;
    int threads = 1;  ///< that may work at once
    const Budget& budget;
    const SearchCallbacks& callbacks;
    std::int64_t bound;  ///< plans cost less, by the task's costs
    /// Plans cost less than this too, whenever it is lowered; may be null.
    const SharedBound* shared_bound = nullptr;
    /// Among engines that take turns; may be null.
    Seat* seat = nullptr;
};

/// Runs an engine. The outcome has the best plan found, whatever ended the search.
Outcome run_engine(const SearchRun& run, const Call& call);

/// Engines one after the other, each looking for a cheaper plan than those before (iterated.cpp).
Outcome run_iterated(const SearchRun& run, const Call& call);

/// Engines side by side (portfolio.cpp).
Outcome run_portfolio(const SearchRun& run, const Call& call);

/// Improvement of the best plan so far (polish.cpp).
Outcome run_polish(const SearchRun& run, const Call& call);

/// An engine on the task without what h2 shows to be useless (pruned.cpp).
Outcome run_pruned(const SearchRun& run, const Call& call);

}  // namespace praxis
