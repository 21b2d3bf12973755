#include "app/belief_exploration.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/belief_runs.hpp"
#include "app/belief_table.hpp"
#include "app/belief_teller.hpp"
#include "app/belief_worlds.hpp"
#include "belief/explore.hpp"
#include "belief/simulated_robot.hpp"
#include "search/text/output.hpp"

namespace praxis::app {
namespace {

using namespace praxis::belief;

void refuse_options(const BeliefOptions& options) {
    const std::pair<bool, const char*> refused[] = {
        {options.offline, "--offline"},
        {options.policy != "plan", "--policy"},
        {options.optimum, "--optimum"},
        {!options.view.empty(), "--view"},
        {!options.observer.empty(), "--observer"},
    };
    for (const auto& [given, name] : refused)
        if (given)
            throw std::invalid_argument(std::string(name) +
                                        " does not go with ':hidden-objects': it needs a task that does not "
                                        "grow. Move these objects to ':objects', or leave the option out");
}

std::string name(const ActionName& action) {
    std::string text;
    for (const std::string& word : action.words) text += (text.empty() ? "(" : " ") + word;
    return text + ")";
}

BeliefRun explore_world(Run& run, const BeliefOptions& options,
                        const std::shared_ptr<const ContingentTask>& full,
                        const std::shared_ptr<const BeliefTask>& task, const WorldState& first,
                        std::size_t number, BeliefTeller& teller) {
    const double start = processor_seconds();
    SimulatedWorld world(task, first, options.noise, options.seed + number, options.failures);
    SimulatedRobot robot(task, world);
    CompilationOptions compilation;
    compilation.risk = options.risk;
    teller.begin(number);
    const Exploration exploration = explore(
        full, robot, robot, belief_agent_options(options, 0), run.budget(),
        [&](const Event& event, const Belief& belief) { teller.tell(event, belief); }, compilation);
    const double seconds = processor_seconds() - start;
    BeliefRun result = judge_belief_run(*task, first, world, exploration.status);
    result.processor_seconds = seconds;
    result.world = number;
    // No more than a proof for the objects found so far.
    result.infeasible = false;
    set_searches(result, exploration.plan_seconds);
    if (!result.false_success) result.message = exploration.message;
    for (const ActionName& action : exploration.actions) result.actions.push_back(name(action));
    result.length = static_cast<double>(exploration.actions.size());
    result.found = exploration.found;
    return result;
}

}  // namespace

Ending explore_belief_task(Run& run, const BeliefOptions& options,
                           const std::shared_ptr<const ContingentTask>& full) {
    refuse_options(options);
    run.set_phase("grounding");
    const GroundBeliefResult ground = ground_belief(full, run.budget());
    if (!ground.task) return run.stopped(ground.stop);
    BeliefWorlds worlds(*ground.task, options);
    const bool single = worlds.count() == 1;
    BeliefTeller teller(single, !options.trace.empty());
    std::vector<BeliefRun> runs;
    run.set_phase("acting");
    for (std::size_t i = 0; i < worlds.count(); ++i) {
        if (run.budget().exhausted() != Stop::none && !runs.empty()) break;
        runs.push_back(explore_world(run, options, full, ground.task, worlds.next(i), i, teller));
        run.update([&](Report& report) { report.runs.push_back(runs.back()); });
    }
    if (options.trace != "-") run.set_result(single ? teller.text() : belief_table(runs, false));
    if (!options.trace.empty()) write_file(options.trace, teller.trace());
    return belief_ending(run, runs, worlds.count());
}

}  // namespace praxis::app
