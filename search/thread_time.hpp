// Processor time of one thread.
#pragma once

#include <time.h>

namespace praxis {

/// Processor seconds that the calling thread has used so far.
inline double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

}  // namespace praxis
