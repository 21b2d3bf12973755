#include "belief/measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace praxis::belief {
namespace {

template <class Length>
std::optional<IntervalEstimate> spl(std::span<const MeasuredRun> runs, Length length) {
    std::vector<double> values;
    for (const MeasuredRun& run : runs) {
        const std::optional<double> best = length(run);
        if (!best) return std::nullopt;
        values.push_back(success_weighted(run.success, run.length, *best));
    }
    return fraction_estimate(values);
}

std::optional<double> length_ratio(std::span<const MeasuredRun> runs) {
    double length = 0, best = 0;
    for (const MeasuredRun& run : runs) {
        if (!run.policy_length) return std::nullopt;
        if (!run.success) continue;
        length += run.length;
        best += *run.policy_length;
    }
    if (best == 0) return std::nullopt;
    return length / best;
}

template <class Value>
IntervalEstimate mean_of(std::span<const MeasuredRun> runs, Value value) {
    std::vector<double> values;
    for (const MeasuredRun& run : runs) values.push_back(value(run));
    return mean_estimate(values);
}

std::string line(const char* name, const std::optional<IntervalEstimate>& estimate, double scale,
                 int digits) {
    char text[128];
    if (!estimate) {
        std::snprintf(text, sizeof text, "%-16s         -\n", name);
    } else if (!std::isfinite(estimate->low)) {
        std::snprintf(text, sizeof text, "%-16s %9.*f\n", name, digits, scale * estimate->value);
    } else {
        std::snprintf(text, sizeof text, "%-16s %9.*f  [%.*f, %.*f]\n", name, digits, scale * estimate->value,
                      digits, scale * estimate->low, digits, scale * estimate->high);
    }
    return text;
}

}  // namespace

double success_weighted(bool success, double length, double best) {
    if (!(length >= 0 && best >= 0 && std::isfinite(length) && std::isfinite(best)))
        throw std::invalid_argument("lengths must be finite and not negative");
    if (!success) return 0;
    const double longest = std::max(length, best);
    return longest == 0 ? 1 : best / longest;
}

Measures measure(std::span<const MeasuredRun> runs) {
    Measures result;
    result.runs = runs.size();
    if (runs.empty()) return result;
    std::int64_t successes = 0, false_successes = 0;
    std::vector<double> successful;
    for (const MeasuredRun& run : runs) {
        successes += run.success;
        false_successes += run.false_success;
        if (run.success) successful.push_back(run.length);
    }
    const auto trials = static_cast<std::int64_t>(runs.size());
    result.success = proportion_estimate(successes, trials);
    result.false_success = proportion_estimate(false_successes, trials);
    result.spl_info = spl(runs, [](const MeasuredRun& run) { return run.policy_length; });
    result.spl_omni = spl(runs, [](const MeasuredRun& run) { return run.omniscient_length; });
    result.length_ratio = length_ratio(runs);
    result.length = mean_of(runs, [](const MeasuredRun& run) { return run.length; });
    if (!successful.empty()) result.successful_length = mean_estimate(successful);
    result.plans = mean_of(runs, [](const MeasuredRun& run) { return static_cast<double>(run.plans); });
    result.processor_seconds = mean_of(runs, [](const MeasuredRun& run) { return run.processor_seconds; });
    return result;
}

std::string to_string(const Measures& measures) {
    char head[64], ratio[64] = "";
    std::snprintf(head, sizeof head, "%zu runs, means and 95 %% intervals\n", measures.runs);
    if (measures.length_ratio)
        std::snprintf(ratio, sizeof ratio, "%-16s %9.3f\n", "steps / best", *measures.length_ratio);
    std::string text = head;
    text += line("success %", measures.success, 100, 1);
    text += line("false success %", measures.false_success, 100, 1);
    text += line("SPL (informed)", measures.spl_info, 1, 3);
    text += line("SPL (omniscient)", measures.spl_omni, 1, 3);
    text += ratio;
    text += line("steps", measures.length, 1, 2);
    text += line("of successes", measures.successful_length, 1, 2);
    text += line("plans", measures.plans, 1, 2);
    text += line("cpu ms", measures.processor_seconds, 1e3, 3);
    return text;
}

}  // namespace praxis::belief
