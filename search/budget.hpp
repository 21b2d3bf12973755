// What a long call may spend, and how it is told to stop.
//
// A Budget is a small value handed down by const reference; every loop that may run long asks `exhausted()`
// at least every few thousand steps (it costs some tens of nanoseconds; memory is looked at every few
// milliseconds only).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>

namespace praxis {

/// Why a budget ran out.
enum class Stop : std::uint8_t { none, time, memory, interrupted };

/// Limits on wall time, processor time and resident memory of the process, and a stop token. Unlimited by
/// default. Copies share nothing; may be asked from several threads at once if each has its own copy.
class Budget {
  public:
    using Clock = std::chrono::steady_clock;

    Budget() = default;

    /// Seconds of wall time from now; non-positive: already exhausted.
    Budget& limit_wall_time(double seconds);
    /// Seconds of processor time of this process from now.
    Budget& limit_processor_time(double seconds);
    /// Resident bytes of this process.
    Budget& limit_memory(std::size_t bytes);
    Budget& stop_with(std::stop_token token);

    /// A budget with a part of the time and of the memory that is left.
    Budget share(double of_time, double of_memory) const;
    std::stop_token stop_token() const { return token_; }

    /// A budget that ends when this one does, or after `seconds` of wall time.
    Budget within(double seconds) const;

    /// Stop::none while there is something left. Once exhausted, always exhausted.
    Stop exhausted() const;
    /// Wall seconds left; a large number if unlimited.
    double seconds_left() const;

  private:
    std::optional<Clock::time_point> deadline_;
    std::optional<double> processor_deadline_;
    std::optional<std::size_t> memory_;
    std::stop_token token_;
    mutable Clock::time_point next_memory_look_{};
    mutable Stop seen_ = Stop::none;
};

/// Processor seconds this process has used so far.
double processor_seconds();
/// Resident and peak resident bytes of this process.
std::size_t resident_memory();
std::size_t peak_memory();

}  // namespace praxis
