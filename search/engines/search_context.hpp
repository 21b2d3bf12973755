// All that a running search works with. An engine is a function on it.
#pragma once

#include <optional>

#include "search/engines/search_monitor.hpp"
#include "search/engines/search_plan.hpp"
#include "search/engines/search_space.hpp"
#include "search/engines/state_evaluator.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

struct SearchContext {
    SearchContext(const SearchRun& run, const SearchPlan& search_plan, std::vector<Heuristic> heuristics,
                  const Budget& budget)
        : plan(search_plan),
          evaluator(std::move(heuristics), plan),
          space(run.prepared.parts(), run.query, plan, evaluator.remembered()),
          monitor(budget, run.callbacks, run.seat, search_plan.max_work),
          callbacks(run.callbacks) {}

    const SearchPlan& plan;
    StateEvaluator evaluator;
    SearchSpace space;
    SearchMonitor monitor;
    const SearchCallbacks& callbacks;
    bool complete = true;  ///< nothing was left out without a proof that no plan goes through it
    std::optional<std::vector<OperatorId>> best;  ///< the best plan found
    std::int64_t best_cost = 0;

    /// The search has reached a goal state. Returns whether it is to go on.
    bool found(StateId goal) {
        std::vector<OperatorId> way = space.plan_to(goal);
        const std::int64_t cost = cost_of(space.task(), way).cost;
        if (!best || cost < best_cost) {
            best = std::move(way);
            best_cost = cost;
            if (callbacks.on_plan) callbacks.on_plan(*best, cost);
            space.lower_bound(cost);
        }
        return plan.go_on;
    }
    bool must_stop() { return monitor.stop(space, evaluator); }
    /// The status of a search that has looked at all it wanted to.
    Status exhausted() const { return complete && !space.bounded() ? Status::unsolvable : Status::failed; }
};

/// Best-first search that evaluates states when they are generated.
Status eager_search(SearchContext& context);
/// Best-first search that evaluates states when their turn comes (Richter and Helmert 2009).
Status lazy_search(SearchContext& context);

}  // namespace praxis
