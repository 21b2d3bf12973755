#include <cstdio>
#include <sstream>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "app/run.hpp"
#include "search/session.hpp"
#include "search/task/sas.hpp"

namespace praxis::app {
namespace {

/// One line a phase: name, time, memory, counts.
std::string table(const std::vector<PhaseStatistics>& phases) {
    std::string text = "phase              time     memory  counts\n";
    double total = 0;
    for (const PhaseStatistics& phase : phases) {
        char line[96];
        std::snprintf(line, sizeof line, "%-12s %10s %10s ", phase.name.c_str(),
                      seconds_text(phase.seconds).c_str(), bytes_text(phase.peak_memory).c_str());
        text += line;
        const char* separator = " ";
        for (const auto& [name, count] : phase.counts) {
            text += separator + count_text(count) + " " + name;
            separator = ", ";
        }
        text += "\n";
        total += phase.seconds;
    }
    char line[96];
    std::snprintf(line, sizeof line, "%-12s %10s %10s\n", "all", seconds_text(total).c_str(),
                  bytes_text(peak_memory()).c_str());
    return text + line;
}

std::string counts(const FiniteDomainTask& task) {
    std::size_t derived = 0;
    for (std::int32_t layer : task.axiom_layers) derived += layer >= 0;
    std::string text = "task: " + count_text(task.variable_count()) + " variables (" + count_text(derived) +
                       " derived), " + count_text(task.fact_count()) + " facts, " +
                       count_text(task.operator_count()) + " operators, " + count_text(task.axioms.size()) +
                       " axioms, " + count_text(task.mutex_groups.size()) + " mutex groups; " +
                       bytes_text(task.memory());
    if (task.proved_unsolvable) text += "; proved unsolvable";
    return text + "\n";
}

Ending ground(Run& run, const GroundCommandOptions& options) {
    const Task task = run.load();
    run.set_phase("grounding");
    SessionOptions session_options;
    session_options.replanning = false;
    session_options.lifted_fallback = false;
    Session& session = *new Session(task, session_options, run.budget());  // not torn down: the process ends
    run.update([&](Report& report) { report.phases = session.phases(); });
    std::string text = table(session.phases());
    const auto ground_task = session.ground_task();
    if (!ground_task) {
        run.say(text);
        return run.stopped(run.budget().exhausted());
    }
    text += counts(*ground_task);
    if (!options.sas.empty()) {
        run.set_phase("writing");
        std::ostringstream sas;
        write_sas(*ground_task, sas);
        write_file(options.sas, sas.view());
    }
    if (options.sas != "-") run.set_result(text);
    return {"ground", kSolved, ""};
}

}  // namespace

int run_ground(const GroundCommandOptions& options) {
    Run run(options, "ground", options.domain, options.problem);
    return run.execute([&] { return ground(run, options); });
}

}  // namespace praxis::app
