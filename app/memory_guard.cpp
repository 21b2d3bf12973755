#include "app/memory_guard.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace praxis::app {
namespace {

constexpr std::size_t kReserve = std::size_t{2} << 20;
std::atomic<void*> reserve{nullptr};
std::atomic<bool> failed{false};

void on_failure() {
    failed = true;
    std::free(reserve.exchange(nullptr));
    throw std::bad_alloc();
}

std::size_t read_number(const char* path) {
    unsigned long long number = 0;
    if (std::FILE* file = std::fopen(path, "r")) {
        if (std::fscanf(file, "%llu", &number) != 1) number = 0;
        std::fclose(file);
    }
    return static_cast<std::size_t>(number);
}

}  // namespace

void guard_memory(std::optional<std::size_t> limit_bytes) {
    reserve = std::malloc(kReserve);
    std::set_new_handler(on_failure);
#ifndef PRAXIS_SANITIZED
    if (!limit_bytes) return;
    rlimit now{};
    getrlimit(RLIMIT_DATA, &now);
    const rlim_t hard = *limit_bytes + *limit_bytes / 8 + (rlim_t{64} << 20);
    if (hard < now.rlim_cur) {
        now.rlim_cur = hard;
        setrlimit(RLIMIT_DATA, &now);
    }
#else
    static_cast<void>(limit_bytes);
#endif
}

bool memory_failed() {
    return failed;
}

std::size_t usable_memory() {
    std::size_t bytes =
        static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    for (const char* path : {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (const std::size_t limit = read_number(path); limit != 0) bytes = std::min(bytes, limit);
    return bytes - bytes / 32;
}

}  // namespace praxis::app
