// Improving the best plan so far again and again, with more effort each time.
#include <algorithm>

#include "search/engines/search_plan.hpp"
#include "search/engines/turns.hpp"
#include "search/improve/improve_plan.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

Outcome run_polish(const SearchRun& run, const Call& call) {
    constexpr std::size_t kGrowth = 4;
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
        options.window_states = std::max<std::size_t>(options.max_states / 100, 100);
        improved_from = best.cost;
        std::vector<OperatorId> plan = improve_plan(run.prepared, run.query, best.plan, run.budget, options);
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
