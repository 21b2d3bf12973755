#include "search/engines/prepared_parts.hpp"
#include "search/engines/search_plan.hpp"
#include "search/h2/prune_task.hpp"

namespace praxis {

namespace {

/// What h2 proves is about the task's own question, so the query becomes the task's own.
std::shared_ptr<const FiniteDomainTask> task_of(const SearchRun& run) {
    const std::shared_ptr<const FiniteDomainTask>& task = run.prepared.parts().task;
    if (task->initial_values == run.query.initial_values && task->goal == run.query.goal) return task;
    auto own = std::make_shared<FiniteDomainTask>(*task);
    own->initial_values = run.query.initial_values;
    for (std::size_t v = 0; v < own->variable_count(); ++v) {
        if (own->axiom_layers[v] >= 0) own->initial_values[v] = task->initial_values[v];
    }
    own->goal = run.query.goal;
    return own;
}

}  // namespace

Outcome run_pruned(const SearchRun& run, const Call& call) {
    const Call& engine = call["search"].calls[0];
    const H2Result pruned = prune_with_h2(task_of(run), run.budget, call["seconds"].real);
    if (pruned.task->proved_unsolvable) {
        Outcome outcome;
        outcome.status = Status::unsolvable;
        outcome.no_cheaper_plan = true;
        return outcome;
    }
    if (pruned.removed_operators == 0) return run_engine(run, engine);
    const PreparedTask prepared(pruned.task, run.budget);
    // The operators of the pruned task have other numbers.
    SharedParts shared;
    Incumbent incumbent;
    SearchCallbacks callbacks = run.callbacks;
    callbacks.on_plan = [&](std::span<const OperatorId> plan, std::int64_t cost) {
        incumbent.offer(plan, cost);
        if (!run.callbacks.on_plan) return;
        std::vector<OperatorId> original;
        for (const OperatorId op : plan) original.push_back(pruned.original[op.index()]);
        run.callbacks.on_plan(original, cost);
    };
    Outcome outcome = run_engine({prepared, run.query, shared, incumbent, run.seed, run.threads, run.budget,
                                  callbacks, run.bound, run.shared_bound, run.seat},
                                 engine);
    if (outcome.plan) {
        for (OperatorId& op : *outcome.plan) op = pruned.original[op.index()];
    }
    return outcome;
}

}  // namespace praxis
