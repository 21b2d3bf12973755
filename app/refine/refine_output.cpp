#include "app/refine/refine_output.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "search/text/output.hpp"
#include "tamp/report/csv.hpp"
#include "tamp/report/document_json.hpp"
#include "tamp/report/joint_trajectory.hpp"
#include "tamp/view/trajectory_page.hpp"

namespace praxis::app {
namespace {

using namespace praxis::tamp;
using Json = nlohmann::ordered_json;

std::string number(double value, const char* format = "%.6g") {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

template <class Write>
bool write(const std::string& file, Write&& write_text) {
    if (file.empty()) return false;
    std::ostringstream text;
    write_text(text);
    write_file(file, text.str());
    return file == "-";
}

/// The failures that happened most often, whatever the action.
std::string frequent_failures(const Refinement& refinement) {
    constexpr std::size_t kMost = 6;
    std::map<std::string, std::uint64_t> counts;
    for (const Attempt& attempt : refinement.attempts)
        counts[attempt.stream + ": " +
               (attempt.message.empty() ? std::string(to_string(attempt.reason)) : attempt.message)] +=
            attempt.count;
    std::vector<std::pair<std::string, std::uint64_t>> sorted(counts.begin(), counts.end());
    std::ranges::stable_sort(sorted, std::ranges::greater{}, &std::pair<std::string, std::uint64_t>::second);
    if (sorted.size() > kMost) sorted.resize(kMost);
    std::string text;
    for (const auto& [what, count] : sorted) text += "\n  " + what + " (" + std::to_string(count) + " times)";
    return text.empty() ? text : "\nwhat failed most often:" + text;
}

}  // namespace

std::string plan_text(const Solution& solution) {
    const RefinedPlan& plan = *solution.refinement.plan;
    std::string text;
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        const TrajectoryDocument::Action& action = solution.document.plan[i];
        text += plan.action(i) + "  ; " + number(action.start, "%.3f") + " to " + number(action.end, "%.3f") +
                " s\n";
    }
    text += "; cost = " + number(plan.cost) + "\n";
    text += "; motion = " + number(solution.document.duration(), "%.3f") + " s\n";
    for (const auto& [name, value] : solution.document.values) {
        if (value.kind == "motion") continue;  // the times of the actions
        text += "; " + name + " = " + value.kind;
        for (const double part : value.numbers) text += " " + number(part);
        text += "\n";
    }
    return text;
}

std::string failure_text(const Refinement& refinement) {
    std::string text = refinement.status == RefineStatus::infeasible
                           ? "infeasible at this discretisation, because"
                           : "no plan was found";
    for (const std::string& reason : refinement.reasons) text += "\n  " + reason;
    return text + frequent_failures(refinement);
}

std::string refine_json(const Solution& solution) {
    const Refinement& refinement = solution.refinement;
    const RefineStatistics& statistics = refinement.statistics;
    Json value{{"status", to_string(refinement.status)}};
    if (refinement.plan) {
        Json steps = Json::array();
        for (std::size_t i = 0; i < refinement.plan->steps.size(); ++i)
            steps.push_back(refinement.plan->action(i));
        value["plan"] = Json{{"steps", std::move(steps)},
                             {"cost", refinement.plan->cost},
                             {"duration", solution.document.duration()}};
        value["checked_configurations"] = solution.checked;
    }
    if (!refinement.reasons.empty()) value["reasons"] = refinement.reasons;
    Json phases = Json::object();
    for (const SolvePhase& phase : solution.phases) phases[phase.name] = phase.seconds;
    value["phases"] = std::move(phases);
    value["statistics"] =
        Json{{"searches", statistics.searches},         {"groundings", statistics.groundings},
             {"evaluated", statistics.evaluated},       {"skeletons", statistics.skeletons},
             {"stream_calls", statistics.stream_calls}, {"samples", statistics.samples},
             {"nogoods", statistics.nogoods},           {"objects", statistics.objects},
             {"operators", statistics.operators},       {"rejections", statistics.rejections}};
    Json attempts = Json::array();
    for (const Attempt& attempt : refinement.attempts) {
        if (attempts.size() == 100) break;
        attempts.push_back(Json{{"action", attempt.action},
                                {"stream", attempt.stream},
                                {"reason", to_string(attempt.reason)},
                                {"message", attempt.message},
                                {"count", attempt.count}});
    }
    value["attempts"] = std::move(attempts);
    return value.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool write_motion(const Solution& solution, const RefineCommandOptions& options) {
    const TrajectoryDocument& document = solution.document;
    bool standard = false;
    standard |= write(options.trajectory, [&](std::ostream& out) { out << to_json(document) << '\n'; });
    standard |= write(options.view, [&](std::ostream& out) { write_view(document, out); });
    if (!solution.refinement.plan) return standard;
    standard |= write(options.csv, [&](std::ostream& out) { write_csv(document, options.csv_rate, out); });
    standard |= write(options.yaml, [&](std::ostream& out) {
        write_joint_trajectory(document, JointTrajectoryForm::segments, out);
    });
    return standard;
}

}  // namespace praxis::app
