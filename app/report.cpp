#include "app/report.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/exit_code.hpp"

namespace praxis::app {
namespace {

using Json = nlohmann::ordered_json;

Budget::Clock::time_point start;

Json number(Rational value) {
    if (value.denominator() == 1) return value.numerator();
    return value.to_string();
}

Json to_value(const Plan& plan, const LiftedTask& task) {
    Json steps = Json::array();
    for (const PlanStep& step : plan.steps) {
        Json words = Json::array({task.schemas[step.schema.index()].name});
        for (ObjectId argument : step.arguments) words.push_back(task.objects[argument.index()].name);
        steps.push_back(std::move(words));
    }
    return Json{{"length", plan.steps.size()}, {"cost", number(plan.cost)}, {"steps", std::move(steps)}};
}

Json to_value(const SearchStatistics& statistics) {
    Json value{{"seconds", statistics.seconds},
               {"expanded", statistics.expanded},
               {"evaluated", statistics.evaluated},
               {"generated", statistics.generated},
               {"reopened", statistics.reopened},
               {"dead_ends", statistics.dead_ends},
               {"registered_states", statistics.registered_states},
               {"bytes_per_state", statistics.bytes_per_state}};
    if (statistics.best_estimate) value["best_estimate"] = *statistics.best_estimate;
    return value;
}

Json to_value(const PhaseStatistics& phase) {
    Json value{{"name", phase.name}, {"seconds", phase.seconds}, {"peak_memory", phase.peak_memory}};
    for (const auto& [name, count] : phase.counts) value["counts"][name] = count;
    return value;
}

Json to_value(const BeliefRun& run) {
    Json value{{"world", run.world},
               {"status", run.status},
               {"success", run.success},
               {"false_success", run.false_success},
               {"actions", run.actions.size()},
               {"plans", run.plans},
               {"processor_seconds", run.processor_seconds},
               {"search_seconds", run.search_seconds},
               {"longest_search_seconds", run.longest_search},
               {"length", run.length},
               {"steps", run.actions}};
    if (run.failures > 0) value["failures"] = run.failures;
    if (!run.found.empty()) value["found"] = run.found;
    if (run.policy_cost) value["policy_cost"] = *run.policy_cost;
    if (run.omniscient_cost) value["omniscient_cost"] = *run.omniscient_cost;
    if (!run.message.empty()) value["message"] = run.message;
    return value;
}

Json to_value(const OfflineReport& report) {
    Json value{{"status", report.status},
               {"searches", report.searches},
               {"processor_seconds", report.processor_seconds}};
    if (!report.message.empty()) value["message"] = report.message;
    if (report.plan.empty()) return value;
    value["actions"] = report.actions;
    value["edges"] = report.edges;
    value["depth"] = report.depth;
    value["mean_cost"] = report.mean_cost;
    value["worst_cost"] = report.worst_cost;
    value["mean_actions"] = report.mean_actions;
    value["checked_worlds"] = report.checked_worlds;
    value["all_worlds"] = report.all_worlds;
    value["optimal"] = report.optimal;
    value["plan"] = Json::parse(report.plan);
    return value;
}

}  // namespace

std::string to_json(const Report& report) {
    Json value{{"praxis", PRAXIS_VERSION},      {"command", report.command}, {"status", report.status},
               {"exit_code", report.exit_code}, {"domain", report.domain},   {"problem", report.problem}};
    if (!report.message.empty()) value["message"] = report.message;
    if (report.configuration) {
        value["configuration"] = Json{{"search", report.configuration->expression},
                                      {"seed", report.configuration->seed},
                                      {"threads", report.configuration->threads}};
        if (!report.alias.empty()) value["configuration"]["alias"] = report.alias;
    }
    if (report.plan && report.task) {
        value["plan"] = to_value(*report.plan, *report.task);
        value["plan"]["optimal"] = report.optimal;
    }
    if (report.lifted) value["lifted"] = true;
    if (report.verdict)
        value["verdict"] = Json{{"valid", report.verdict->valid},
                                {"cost", number(report.verdict->cost)},
                                {"failing_step", report.verdict->step}};
    if (report.statistics) value["search"] = to_value(*report.statistics);
    if (!report.phases.empty()) {
        value["phases"] = Json::array();
        for (const PhaseStatistics& phase : report.phases) value["phases"].push_back(to_value(phase));
    }
    for (const BeliefRun& run : report.runs) value["runs"].push_back(to_value(run));
    if (report.offline) value["offline"] = to_value(*report.offline);
    if (!report.practice.empty()) value["practice"] = Json::parse(report.practice);
    if (!report.refine.empty()) value["refine"] = Json::parse(report.refine);
    value["seconds"] = elapsed_seconds();
    value["processor_seconds"] = processor_seconds();
    value["peak_memory"] = peak_memory();
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

const char* status_name(Status status) {
    switch (status) {
        case Status::solved:
            return "solved";
        case Status::unsolvable_early:
            return "unsolvable_early";
        case Status::unsolvable:
            return "unsolvable";
        case Status::failed:
            return "failed";
        case Status::out_of_memory:
            return "out_of_memory";
        case Status::out_of_time:
            return "out_of_time";
        case Status::interrupted:
            return "interrupted";
    }
    return "failed";
}

int exit_code(Status status) {
    switch (status) {
        case Status::solved:
            return kSolved;
        case Status::unsolvable_early:
            return kUnsolvableEarly;
        case Status::unsolvable:
            return kUnsolvable;
        case Status::failed:
            return kFailed;
        case Status::out_of_memory:
            return kOutOfMemory;
        case Status::out_of_time:
            return kOutOfTime;
        case Status::interrupted:
            return kSignalBase;
    }
    return kInternalError;
}

void start_clock() {
    start = Budget::Clock::now();
}

double elapsed_seconds() {
    return std::chrono::duration<double>(Budget::Clock::now() - start).count();
}

std::string seconds_text(double seconds) {
    char text[32];
    if (seconds < 1)
        std::snprintf(text, sizeof text, "%.1f ms", seconds * 1e3);
    else
        std::snprintf(text, sizeof text, "%.1f s", seconds);
    return text;
}

std::string bytes_text(std::size_t bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f MiB", static_cast<double>(bytes) / (1 << 20));
    return text;
}

std::string count_text(std::uint64_t count) {
    const std::string digits = std::to_string(count);
    std::string text;
    for (std::size_t i = 0; i < digits.size(); ++i) {
        if (i != 0 && (digits.size() - i) % 3 == 0) text += ',';
        text += digits[i];
    }
    return text;
}

}  // namespace praxis::app
