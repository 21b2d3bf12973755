// Memory limits of the process, and room to speak when memory is gone.
#pragma once

#include <cstddef>
#include <optional>

namespace praxis::app {

/// Keeps a reserve that the first failing allocation gives back (and then throws std::bad_alloc), so that
/// there is memory left to report with. With a limit, also a hard one of the system a little above it, for
/// single allocations too large to be noticed in time.
void guard_memory(std::optional<std::size_t> limit_bytes);

/// An allocation has failed.
bool memory_failed();

/// What a process may use on this machine: physical memory or the control group's limit, less a little.
std::size_t usable_memory();

}  // namespace praxis::app
