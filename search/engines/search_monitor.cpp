#include "search/engines/search_monitor.hpp"

#include <algorithm>

#include "search/engines/search_space.hpp"
#include "search/engines/state_evaluator.hpp"
#include "search/engines/turns.hpp"

namespace praxis {

namespace {

constexpr auto kReportInterval = std::chrono::milliseconds(250);
constexpr auto kLookInterval = std::chrono::microseconds(1000);
constexpr std::uint32_t kMaximumInterval = 1 << 14;

}  // namespace

SearchMonitor::SearchMonitor(const Budget& budget, const SearchCallbacks& callbacks, Seat* seat)
    : budget_(budget),
      callbacks_(&callbacks),
      start_(Clock::now()),
      last_look_(start_),
      next_report_(start_ + kReportInterval),
      seat_(seat) {
    if (seat_ != nullptr) turn_end_ = seat_->work();
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
    if (seat_ != nullptr && work(evaluator) >= turn_end_) {
        seat_->pass();
        turn_end_ = work(evaluator) + seat_->work();
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
    return status_of(budget_.exhausted());
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
