#include "app/belief_runs.hpp"

#include <algorithm>
#include <numeric>

#include "app/exit_code.hpp"
#include "belief/check_run.hpp"

namespace praxis::app {

using namespace praxis::belief;

AgentOptions belief_agent_options(const BeliefOptions& options, std::size_t axioms) {
    using Mode = BeliefOptions::Mode;
    AgentOptions result = default_agent_options(axioms);
    result.most_steps = options.max_steps;
    if (!options.search.empty()) result.first = configuration(options.search);
    result.first.seed = result.second.seed = options.seed;
    if (options.plan_time) {
        result.second_seconds = *options.plan_time;
        result.plan_seconds = std::min(result.plan_seconds, result.second_seconds);
    }
    const bool doubtful = options.noise > 0 || !options.observer.empty();
    const bool weigh = options.mode == Mode::bayes || (options.mode == Mode::automatic && doubtful);
    if (weigh) result.accept = options.accept;
    // Policies that choose by themselves do not weigh readings; a contradiction must not end their runs.
    result.ignore_contradictions = weigh || options.mode == Mode::sticky;
    return result;
}

BeliefRun judge_belief_run(const BeliefTask& task, const WorldState& first, const SimulatedWorld& world,
                           RunStatus status) {
    BeliefRun run;
    run.status = to_string(status);
    run.infeasible = status == RunStatus::infeasible;
    run.failures = world.failed();
    if (status != RunStatus::reached) return run;
    const Verdict verdict = check_run(task, first, world.happened(), world.after_chance());
    run.success = verdict.valid;
    run.false_success = !verdict.valid;
    if (run.false_success) run.message = verdict.reason;
    return run;
}

void set_searches(BeliefRun& run, std::span<const double> plan_seconds) {
    run.plans = plan_seconds.size();
    run.search_seconds = std::accumulate(plan_seconds.begin(), plan_seconds.end(), 0.0);
    for (const double seconds : plan_seconds) run.longest_search = std::max(run.longest_search, seconds);
}

Ending belief_ending(const Run& run, std::span<const BeliefRun> runs, std::size_t worlds) {
    const bool all = std::all_of(runs.begin(), runs.end(), [](const BeliefRun& r) { return r.success; });
    const bool complete = runs.size() == worlds;
    if (const Stop stop = run.budget().exhausted(); stop != Stop::none && !(all && complete))
        return run.stopped(stop);
    if (std::any_of(runs.begin(), runs.end(), [](const BeliefRun& r) { return r.infeasible; }))
        return {"unsolvable", kUnsolvable, ""};
    for (const BeliefRun& r : runs)
        if (!r.error.empty()) return {"failed", kFailed, "the observer failed: " + r.error};
    if (worlds == 1 && runs[0].false_success)
        return {"failed", kFailed, "the goal is believed to hold, but does not: " + runs[0].message};
    return all ? Ending{"solved", kSolved, ""} : Ending{"failed", kFailed, ""};
}

}  // namespace praxis::app
