// Watches over the process from a thread of its own: signals, the time limit, and calls that do not look at
// their budget.
//
// The first SIGINT, SIGTERM or SIGXCPU requests a stop through `token()`; a second one kills. When the time
// limit or a signal has passed and the main thread is still busy `kGrace` later, `on_overrun` is called on
// the watcher's thread; it writes what there is and ends the process. `finish()` tells that the main thread
// is about to do that itself.
#pragma once

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>

#include "search/budget.hpp"

namespace praxis::app {

class Watcher {
  public:
    using Clock = Budget::Clock;
    static constexpr std::chrono::milliseconds kGrace{70};

    struct Hooks {
        std::function<void(Stop)> on_overrun;  ///< must not return
        std::function<void()> on_tick;         ///< now and then, for progress; may be empty
        std::chrono::milliseconds tick{1000};
    };

    /// Blocks the signals and starts to watch. One watcher a process.
    Watcher(std::optional<Clock::time_point> deadline, Hooks hooks);
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;

    std::stop_token token() const { return source_.get_token(); }
    /// The signal that asked for the stop, or 0.
    int signal() const { return signal_.load(std::memory_order_acquire); }
    void finish() { finished_.store(true, std::memory_order_release); }

  private:
    static void* run(void* self);
    void watch();
    void take(int signal);

    std::optional<Clock::time_point> deadline_;
    Hooks hooks_;
    sigset_t signals_;
    std::stop_source source_;
    std::atomic<int> signal_{0};
    std::atomic<bool> finished_{false};
};

}  // namespace praxis::app
