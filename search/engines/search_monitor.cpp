#include "search/engines/search_monitor.hpp"

#include <algorithm>
#include <limits>

#include "search/engines/search_space.hpp"
#include "search/engines/state_evaluator.hpp"
#include "search/engines/turns.hpp"

namespace praxis {

namespace {

constexpr auto kReportInterval = std::chrono::milliseconds(250);
constexpr auto kLookInterval = std::chrono::microseconds(1000);
constexpr std::uint32_t kMaximumInterval = 1 << 14;
constexpr double kWorkPerSecond = 1e9;
constexpr std::uint64_t kNoEnd = std::numeric_limits<std::uint64_t>::max();

}  // namespace

SearchMonitor::SearchMonitor(const Budget& budget, const SearchCallbacks& callbacks, Seat* seat,
                             double most_work)
    : budget_(budget),
      callbacks_(&callbacks),
      start_(Clock::now()),
      last_look_(start_),
      next_report_(start_ + kReportInterval),
      seat_(seat),
      work_end_(most_work < 1e9 ? static_cast<std::uint64_t>(most_work * kWorkPerSecond) : kNoEnd) {
    turn_end_ = std::min(work_end_, seat_ == nullptr ? kNoEnd : seat_->work());
}

bool SearchMonitor::look(const SearchSpace& space, const StateEvaluator& evaluator) {
    const auto now = Clock::now();
    const auto since = now - last_look_;
    last_look_ = now;
    if (since < kLookInterval / 2) {
        interval_ = std::min(interval_ * 2, kMaximumInterval);
    } else if (since > kLookInterval * 2) {
        interval_ = std::max(interval_ / 4, 1u);
    }
    countdown_ = interval_;
    if (work(evaluator) >= work_end_) {
        spent_ = true;
        return true;
    }
    if (seat_ != nullptr && work(evaluator) >= turn_end_) {
        seat_->pass();
        turn_end_ = std::min(work_end_, work(evaluator) + seat_->work());
        last_look_ = Clock::now();
    }
    if (callbacks_->on_progress && now >= next_report_) {
        next_report_ = now + kReportInterval;
        finish(space, evaluator);
        callbacks_->on_progress(statistics);
    }
    return budget_.exhausted() != Stop::none;
}

Status SearchMonitor::status() const {
    return spent_ ? Status::out_of_time : status_of(budget_.exhausted());
}

void SearchMonitor::finish(const SearchSpace& space, const StateEvaluator& evaluator) {
    statistics.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    statistics.registered_states = space.size();
    statistics.bytes_per_state = space.bytes_per_state();
    statistics.peak_memory = peak_memory();
    statistics.best_estimate = evaluator.best_estimate();
}

Status status_of(Stop stop) {
    switch (stop) {
        case Stop::time:
            return Status::out_of_time;
        case Stop::memory:
            return Status::out_of_memory;
        case Stop::interrupted:
            return Status::interrupted;
        case Stop::none:
            break;
    }
    return Status::failed;
}

}  // namespace praxis
