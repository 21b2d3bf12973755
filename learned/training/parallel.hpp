// The same work on several threads.
#pragma once

#include <exception>
#include <thread>
#include <vector>

namespace praxis::learned {

/// body(thread) for each thread in 0..threads-1, the last of them here. The first exception is thrown again
/// here.
template <class Body>
void run_parallel(int threads, const Body& body) {
    std::vector<std::exception_ptr> errors(static_cast<std::size_t>(threads));
    const auto guarded = [&](int thread) {
        try {
            body(thread);
        } catch (...) {
            errors[static_cast<std::size_t>(thread)] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> others;
        for (int thread = 0; thread + 1 < threads; ++thread) others.emplace_back(guarded, thread);
        guarded(threads - 1);
    }
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
}

}  // namespace praxis::learned
