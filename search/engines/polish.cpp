// Improving the best plan so far again and again, with more effort each time.
#include <algorithm>
#include <chrono>

#include "search/engines/search_plan.hpp"
#include "search/engines/turns.hpp"
#include "search/improve/improve_plan.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

Outcome run_polish(const SearchRun& run, const Call& call) {
    constexpr std::size_t kGrowth = 4;
    constexpr std::size_t kFirstWithWindows = 1'000'000;
    constexpr std::size_t kWindowStates = 300;
    constexpr double kLeastSeconds = 1;
    const Budget::Clock::time_point start = Budget::Clock::now();
    Outcome outcome;
    ImproveOptions options;
    const auto most = static_cast<std::size_t>(call.integer("states"));
    options.max_states = std::min<std::size_t>(static_cast<std::size_t>(call.integer("first")), most);
    std::int64_t improved_from = kInfinity;
    while (run.budget.exhausted() == Stop::none) {
        const Incumbent::Best best = run.incumbent.best();
        if (!best.found()) break;
        if (best.cost == improved_from) {  // all that this effort can do has been done
            if (options.max_states == most) break;
            options.max_states = std::min(options.max_states * kGrowth, most);
        }
        options.window_states = options.max_states < kFirstWithWindows ? 0 : kWindowStates;
        improved_from = best.cost;
        // Others may be waiting for their turns.
        const double elapsed = std::chrono::duration<double>(Budget::Clock::now() - start).count();
        const Budget turn = run.budget.within(std::max(kLeastSeconds, elapsed / 2));
        std::vector<OperatorId> plan = improve_plan(run.prepared, run.query, best.plan, turn, options);
        const std::int64_t cost = cost_of(run.prepared.task(), plan).cost;
        if (cost < best.cost) {
            if (run.callbacks.on_plan) run.callbacks.on_plan(plan, cost);
            outcome.plan = std::move(plan);
            outcome.cost = improved_from = cost;
        }
        if (run.seat != nullptr) run.seat->pass();
    }
    const Stop stop = run.budget.exhausted();
    outcome.status = stop != Stop::none ? status_of(stop) : outcome.plan ? Status::solved : Status::failed;
    return outcome;
}

}  // namespace praxis
