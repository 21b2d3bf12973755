// Counts what a search does, and asks now and then whether it may go on.
#pragma once

#include <chrono>
#include <cstdint>

#include "search/budget.hpp"
#include "search/engines/search.hpp"

namespace praxis {

class SearchSpace;
class StateEvaluator;

class SearchMonitor {
  public:
    SearchMonitor(const Budget& budget, const SearchCallbacks& callbacks);

    SearchStatistics statistics;

    /// To be asked at least once a millisecond or so of work; asks the budget about that often, and reports
    /// progress. True: the search must end.
    bool stop(const SearchSpace& space, const StateEvaluator& evaluator) {
        return --countdown_ == 0 && look(space, evaluator);
    }
    /// Why the search must end, as a status.
    Status status() const;
    /// Fills in the statistics that are not counted.
    void finish(const SearchSpace& space, const StateEvaluator& evaluator);

  private:
    using Clock = Budget::Clock;
    bool look(const SearchSpace& space, const StateEvaluator& evaluator);

    Budget budget_;
    const SearchCallbacks* callbacks_;
    Clock::time_point start_;
    Clock::time_point last_look_;
    Clock::time_point next_report_;
    std::uint32_t interval_ = 1;
    std::uint32_t countdown_ = 1;
};

/// The status of a search that a budget has stopped.
Status status_of(Stop stop);

}  // namespace praxis
