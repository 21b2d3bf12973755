#include "app/belief_offline.hpp"

#include "app/exit_code.hpp"
#include "app/output.hpp"
#include "belief/offline/offline.hpp"
#include "belief/offline/offline_texts.hpp"

namespace praxis::app {

using belief::OfflineResult;
using belief::OfflineStatus;

namespace {

OfflineReport report_of(const OfflineResult& result, const belief::OfflineTexts& texts) {
    OfflineReport report;
    report.status = to_string(result.status);
    report.message = result.message;
    report.searches = result.plans;
    report.processor_seconds = result.seconds;
    if (result.status != OfflineStatus::found) return report;
    report.plan = texts.json;
    report.actions = result.plan.action_nodes();
    report.edges = result.plan.edge_count();
    report.depth = result.plan.depth();
    report.mean_cost = result.costs.mean;
    report.worst_cost = result.costs.worst;
    report.mean_actions = result.costs.mean_actions;
    report.checked_worlds = result.checked;
    report.all_worlds = result.all_worlds;
    report.optimal = result.optimal;
    return report;
}

std::string file_name(const std::string& path) {
    return path.substr(path.find_last_of('/') + 1);
}

}  // namespace

Ending make_offline_plan(Run& run, const BeliefOptions& options, const belief::KnowledgePlanner& planner) {
    run.set_phase("planning");
    belief::OfflineOptions offline;
    if (!options.search.empty()) {
        offline.search = configuration(options.search);
        offline.search->seed = options.seed;
    }
    offline.seed = options.seed;
    const OfflineResult result = belief::plan_offline(planner, offline, run.budget());
    const belief::BeliefTask& task = planner.compilation().belief();
    const belief::OfflineTexts texts = offline_texts(task, result, file_name(options.problem));
    run.update([&](Report& report) { report.offline = report_of(result, texts); });
    switch (result.status) {
        case OfflineStatus::found:
            break;
        case OfflineStatus::unsolvable:
            return {"unsolvable", kUnsolvable, "there is no conditional plan: " + result.message};
        case OfflineStatus::not_found:
            return {"failed", kFailed,
                    "no conditional plan was found" + (result.message.empty() ? "" : ": " + result.message)};
        case OfflineStatus::limit: {
            const Stop stop = run.budget().exhausted();
            return run.stopped(stop == Stop::none ? Stop::time : stop);
        }
        case OfflineStatus::unsupported:
            return {"unsupported", kUnsupported, "plan: error: no conditional plan: " + result.message};
    }
    const bool printed = options.dot != "-" && options.html != "-" && options.json != "-";
    if (printed) run.set_result(texts.text);
    if (!printed) run.say(texts.summary);
    if (!options.dot.empty()) write_file(options.dot, texts.dot);
    if (!options.html.empty()) write_file(options.html, texts.html);
    return {"solved", kSolved, ""};
}

}  // namespace praxis::app
