// Task and motion planning without geometry: blocks on a line (domains/tamp/line), from PDDL text to values;
// and items on a cluttered shelf, with what rejections blame and without.
#include <benchmark/benchmark.h>

#include "tests/tamp/support/line_world.hpp"
#include "tests/tamp/support/shelf_world.hpp"

namespace praxis::tamp {
namespace {

void refine_line(benchmark::State& state, const std::string& name,
                 const std::map<std::string, Value, std::less<>>& values) {
    const StreamLibrary library = test::LineWorld{}.library();
    std::uint64_t seed = 0;
    RefineStatistics last;
    for (auto _ : state) {
        const StreamTask task = test::load_line(PRAXIS_SOURCE_DIR, name);
        RefinementProblem problem{&task, &library, values, {}};
        problem.options.seed = seed++;
        const Refinement result = refine(problem);
        if (result.status != RefineStatus::solved) state.SkipWithError("not solved");
        last.ground_seconds += result.statistics.ground_seconds;
        last.search_seconds += result.statistics.search_seconds;
        last.sample_seconds += result.statistics.sample_seconds;
        last.skeletons += result.statistics.skeletons;
        last.stream_calls += result.statistics.stream_calls;
        last.groundings += result.statistics.groundings;
    }
    const auto mean = [&](double sum) { return sum / static_cast<double>(state.iterations()); };
    state.counters["ground_ms"] = 1e3 * mean(last.ground_seconds);
    state.counters["search_ms"] = 1e3 * mean(last.search_seconds);
    state.counters["sample_ms"] = 1e3 * mean(last.sample_seconds);
    state.counters["skeletons"] = mean(static_cast<double>(last.skeletons));
    state.counters["groundings"] = mean(static_cast<double>(last.groundings));
    state.counters["calls"] = mean(static_cast<double>(last.stream_calls));
}

void tight(benchmark::State& state) {
    refine_line(state, "tight", test::tight_values());
}
void blocked(benchmark::State& state) {
    refine_line(state, "blocked", test::blocked_values());
}

/// 40 items, a row of five a lane, `lanes` lanes; the target stands behind four others. Arguments: lanes,
/// blame.
void clutter(benchmark::State& state) {
    test::ShelfWorld world;
    world.rows = static_cast<int>(state.range(0));
    world.depths = 5;
    world.target = 4;
    for (int item = 0; item < 40; ++item) world.start.push_back(item);
    const StreamTask task = world.task();
    const StreamLibrary library = world.library();
    RefineStatistics last;
    std::uint64_t solved = 0;
    for (auto _ : state) {
        RefinementProblem problem{&task, &library, world.values(), {}};
        problem.options.nogoods = state.range(1) != 0;
        Budget budget;
        budget.limit_wall_time(20);
        const Refinement result = refine(problem, budget);
        solved += result.status == RefineStatus::solved ? 1 : 0;
        last = result.statistics;
    }
    state.counters["solved"] = static_cast<double>(solved) / static_cast<double>(state.iterations());
    state.counters["searches"] = static_cast<double>(last.searches);
    state.counters["calls"] = static_cast<double>(last.stream_calls);
    state.counters["search_ms"] = 1e3 * last.search_seconds;
    state.counters["ground_ms"] = 1e3 * last.ground_seconds;
}

BENCHMARK(tight)->Unit(benchmark::kMillisecond);
BENCHMARK(blocked)->Unit(benchmark::kMillisecond);
BENCHMARK(clutter)->Args({12, 1})->Args({12, 0})->Args({10, 1})->Args({10, 0})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace praxis::tamp
