// Whether a benchmark is only to show that it runs.
#pragma once

#include <string_view>

namespace praxis {

/// The one argument is Google Benchmark's for a moment's run, as .ci/run gives it to every benchmark.
inline bool is_smoke_run(int argc, char** argv) {
    return argc == 2 && std::string_view(argv[1]).starts_with("--benchmark_min_time=");
}

}  // namespace praxis
