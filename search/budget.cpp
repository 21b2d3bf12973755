#include "search/budget.hpp"

#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>

namespace praxis {

Budget& Budget::limit_wall_time(double seconds) {
    const auto length = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    const auto at = Clock::now() + length;
    if (!deadline_ || at < *deadline_) deadline_ = at;
    return *this;
}

Budget& Budget::limit_processor_time(double seconds) {
    const double at = processor_seconds() + seconds;
    if (!processor_deadline_ || at < *processor_deadline_) processor_deadline_ = at;
    return *this;
}

Budget& Budget::limit_memory(std::size_t bytes) {
    if (!memory_ || bytes < *memory_) memory_ = bytes;
    return *this;
}

Budget& Budget::stop_with(std::stop_token token) {
    token_ = std::move(token);
    return *this;
}

Budget Budget::within(double seconds) const {
    Budget part = *this;
    part.limit_wall_time(seconds);
    return part;
}

Budget Budget::share(double of_time, double of_memory) const {
    Budget part = *this;
    if (deadline_ || processor_deadline_) part.limit_wall_time(seconds_left() * of_time);
    if (memory_) {
        const std::size_t used = std::min(resident_memory(), *memory_);
        part.limit_memory(used + static_cast<std::size_t>(static_cast<double>(*memory_ - used) * of_memory));
    }
    return part;
}

Stop Budget::exhausted() const {
    if (seen_ != Stop::none) return seen_;
    if (token_.stop_requested()) return seen_ = Stop::interrupted;
    if (!deadline_ && !memory_ && !processor_deadline_) return Stop::none;
    const auto now = Clock::now();
    if (deadline_ && now >= *deadline_) return seen_ = Stop::time;
    if ((memory_ || processor_deadline_) && now >= next_memory_look_) {
        next_memory_look_ = now + std::chrono::milliseconds(5);
        if (memory_ && resident_memory() > *memory_) return seen_ = Stop::memory;
        if (processor_deadline_ && processor_seconds() >= *processor_deadline_) return seen_ = Stop::time;
    }
    return Stop::none;
}

double Budget::seconds_left() const {
    double left = std::numeric_limits<double>::max();
    if (deadline_) left = std::chrono::duration<double>(*deadline_ - Clock::now()).count();
    if (processor_deadline_) left = std::min(left, *processor_deadline_ - processor_seconds());
    return left;
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

std::size_t resident_memory() {
    std::size_t pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        std::size_t total = 0;
        if (std::fscanf(file, "%zu %zu", &total, &pages) != 2) pages = 0;
        std::fclose(file);
    }
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::size_t peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

}  // namespace praxis
