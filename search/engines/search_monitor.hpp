// Counts what a search does, and asks now and then whether it may go on.
#pragma once

#include <chrono>
#include <cstdint>

#include "search/budget.hpp"
#include "search/engines/search.hpp"
#include "search/engines/state_evaluator.hpp"

namespace praxis {

class SearchSpace;
class Seat;

class SearchMonitor {
  public:
    /// Where engines take turns, `seat` is the search's; null otherwise. `most_work`: in counted seconds.
    SearchMonitor(const Budget& budget, const SearchCallbacks& callbacks, Seat* seat, double most_work);

    SearchStatistics statistics;

    /// To be asked at least once a millisecond or so of work; asks the budget about that often, and reports
    /// progress. True: the search must end.
    bool stop(const SearchSpace& space, const StateEvaluator& evaluator) {
        if (--countdown_ != 0 && work(evaluator) < turn_end_) return false;
        return look(space, evaluator);
    }
    /// Why the search must end, as a status.
    Status status() const;
    /// Fills in the statistics that are not counted.
    void finish(const SearchSpace& space, const StateEvaluator& evaluator);

  private:
    using Clock = Budget::Clock;
    bool look(const SearchSpace& space, const StateEvaluator& evaluator);

    /// What the search has done, in steps of about a nanosecond.
    std::uint64_t work(const StateEvaluator& evaluator) const {
        return evaluator.effort() + 400 * statistics.evaluated + 20 * statistics.generated;
    }

    Budget budget_;
    const SearchCallbacks* callbacks_;
    Clock::time_point start_;
    Clock::time_point last_look_;
    Clock::time_point next_report_;
    std::uint32_t interval_ = 1;
    std::uint32_t countdown_ = 1;
    Seat* seat_;
    std::uint64_t turn_end_;  ///< the work at which the turn, or all of it, is over
    std::uint64_t work_end_;  ///< the work at which the search is over
    bool spent_ = false;
};

}  // namespace praxis
