#include "app/belief_table.hpp"

#include <cstdio>
#include <optional>
#include <vector>

#include "belief/measures.hpp"

namespace praxis::app {

namespace {

std::string number(const std::optional<double>& value) {
    if (!value) return "not known";
    char text[32];
    std::snprintf(text, sizeof text, "%g", *value);
    return text;
}

std::string measures_of(std::span<const BeliefRun> runs) {
    std::vector<belief::MeasuredRun> measured;
    for (const BeliefRun& run : runs)
        measured.push_back({run.success, run.false_success, run.length, run.policy_cost, run.omniscient_cost,
                            run.plans, run.processor_seconds});
    return belief::to_string(belief::measure(measured));
}

}  // namespace

std::string belief_comparison(const BeliefRun& run) {
    return "; cost " + number(run.length) + "; of the best policy in this world: " + number(run.policy_cost) +
           "; of one who knows the world: " + number(run.omniscient_cost) + "\n";
}

std::string belief_table(std::span<const BeliefRun> runs, bool measures) {
    std::string text;
    char line[256];
    std::size_t successes = 0, false_successes = 0, actions = 0, plans = 0;
    double seconds = 0;
    for (const BeliefRun& run : runs) {
        successes += run.success;
        false_successes += run.false_success;
        actions += run.actions.size();
        plans += run.plans;
        seconds += run.processor_seconds;
    }
    const auto count = static_cast<double>(runs.size());
    std::snprintf(line, sizeof line,
                  "%zu runs: %zu reached the goal (%.1f %%), %zu believed so wrongly; means: %.1f actions, "
                  "%.1f plans, %.4f s of processor time\n",
                  runs.size(), successes, 100.0 * static_cast<double>(successes) / count, false_successes,
                  static_cast<double>(actions) / count, static_cast<double>(plans) / count, seconds / count);
    text += line;
    if (measures) text += measures_of(runs);
    for (const BeliefRun& run : runs) {
        if (run.success) continue;
        text += "world " + std::to_string(run.world) + ": " + run.status;
        if (!run.message.empty()) text += " (" + run.message + ")";
        text += "\n";
    }
    return text;
}

}  // namespace praxis::app
