#include <cstdio>
#include <stdexcept>
#include <string>

#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/refine/refine_commands.hpp"
#include "app/refine/refine_output.hpp"
#include "app/run.hpp"
#include "tamp/view/trajectory_page.hpp"

namespace praxis::app {
namespace {

using namespace praxis::tamp;

std::string progress_text(const RefineStatistics& statistics) {
    return count_text(statistics.skeletons) + " plans tried, " + count_text(statistics.stream_calls) +
           " samples, " + count_text(statistics.nogoods) + " lessons";
}

Ending ending_of(const Run& run, const Refinement& refinement) {
    switch (refinement.status) {
        case RefineStatus::solved:
            return {"solved", kSolved, ""};
        case RefineStatus::infeasible:
            return {"infeasible", kUnsolvable, failure_text(refinement)};
        case RefineStatus::cancelled:
        case RefineStatus::out_of_budget:
            break;
    }
    const Stop stop = run.budget().exhausted();
    if (stop == Stop::none) return {"failed", kFailed, failure_text(refinement)};
    Ending ending = run.stopped(stop);
    ending.message += "; " + failure_text(refinement);
    return ending;
}

void say_phases(Run& run, const Solution& solution) {
    if (!run.verbose()) return;
    for (const SolvePhase& phase : solution.phases) run.say(phase.name + ": " + seconds_text(phase.seconds));
    run.say(progress_text(solution.refinement.statistics));
    if (solution.checked > 0) run.say(count_text(solution.checked) + " configurations checked");
}

Ending refine_files(Run& run, const RefineCommandOptions& options) {
    if (!options.view.empty() && !has_viewer())
        return {"unsupported", kUnsupported,
                "plan: error: this Praxis was built without the viewer (npm was missing); leave --view out"};
    run.set_phase("reading");
    const SceneProblem problem =
        load_scene_problem(options.domain, options.problem, options.streams, options.scene);
    run.say_warnings(problem.warnings, *problem.task.task->sources);
    run.update([&](Report& report) { report.task = problem.task.task; });

    SolveOptions solving;
    solving.refine.seed = options.seed;
    if (!options.search.empty()) solving.refine.search = options.search;
    solving.schedule.speed = solving.schedule.acceleration = options.speed;
    solving.join = !options.by_home;
    SolveCallbacks callbacks;
    callbacks.on_phase = [&run](const char* phase) { run.set_phase(phase); };
    callbacks.on_progress = [&run](const RefineStatistics& statistics) {
        run.set_detail(progress_text(statistics));
    };
    const Solution solution = solve(problem, solving, run.budget(), callbacks);
    run.update([&](Report& report) { report.refine = refine_json(solution); });
    say_phases(run, solution);
    const bool standard = write_motion(solution, options);
    if (solution.refinement.plan && !standard) run.set_result(plan_text(solution));
    return ending_of(run, solution.refinement);
}

}  // namespace

int run_refine(const RefineCommandOptions& options) {
    Run run(options, "refine", options.domain, options.problem);
    return run.execute([&]() -> Ending {
        try {
            return refine_files(run, options);
        } catch (const StreamError& error) {
            return {"input_error", kInputError, std::string("plan: error: ") + error.what()};
        }
    });
}

}  // namespace praxis::app
