#include "belief/measures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace praxis::belief {
namespace {

constexpr double kNormal = 1.959963984540054;  ///< 97.5 % quantile

/// 97.5 % quantiles of Student's t distribution, by degrees of freedom from 1.
constexpr double kStudent[] = {12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469, 2.3646, 2.3060,
                               2.2622,  2.2281, 2.2010, 2.1788, 2.1604, 2.1448, 2.1314, 2.1199,
                               2.1098,  2.1009, 2.0930, 2.0860, 2.0796, 2.0739, 2.0687, 2.0639,
                               2.0595,  2.0555, 2.0518, 2.0484, 2.0452, 2.0423};

/// Beyond the table: the expansion in 1/n of Cornish and Fisher, right to four digits there.
double student(std::size_t freedom) {
    if (freedom <= std::size(kStudent)) return kStudent[freedom - 1];
    const double z = kNormal, n = static_cast<double>(freedom);
    return z + (z * z * z + z) / (4 * n) + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * n * n);
}

template <class Length>
std::optional<Estimate> spl(std::span<const MeasuredRun> runs, Length length) {
    std::vector<double> values;
    for (const MeasuredRun& run : runs) {
        const std::optional<double> best = length(run);
        if (!best) return std::nullopt;
        values.push_back(success_weighted(run.success, run.length, *best));
    }
    if (values.empty()) return std::nullopt;
    Estimate estimate = mean(values);
    estimate.low = std::max(estimate.low, 0.0);
    estimate.high = std::min(estimate.high, 1.0);
    return estimate;
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
Estimate mean_of(std::span<const MeasuredRun> runs, Value value) {
    std::vector<double> values;
    for (const MeasuredRun& run : runs) values.push_back(value(run));
    return mean(values);
}

std::string line(const char* name, const std::optional<Estimate>& estimate, double scale, int digits) {
    char text[128];
    if (estimate) {
        std::snprintf(text, sizeof text, "%-16s %9.*f  [%.*f, %.*f]\n", name, digits, scale * estimate->value,
                      digits, scale * estimate->low, digits, scale * estimate->high);
    } else {
        std::snprintf(text, sizeof text, "%-16s         -\n", name);
    }
    return text;
}

}  // namespace

Estimate rate(std::size_t successes, std::size_t count) {
    if (successes > count) throw std::invalid_argument("more successes than trials");
    if (count == 0) return {0, 0, 1};
    const double n = static_cast<double>(count), p = static_cast<double>(successes) / n;
    const double z2 = kNormal * kNormal;
    const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
    const double half = kNormal / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
    // At the ends the interval ends there exactly; rounding must not say otherwise.
    return {p, successes == 0 ? 0 : std::max(middle - half, 0.0),
            successes == count ? 1 : std::min(middle + half, 1.0)};
}

Estimate mean(std::span<const double> values) {
    if (values.empty()) return {};
    const double n = static_cast<double>(values.size());
    double sum = 0;
    for (const double value : values) sum += value;
    const double average = sum / n;
    if (values.size() == 1) return {average, average, average};
    double squares = 0;
    for (const double value : values) squares += (value - average) * (value - average);
    const double half = student(values.size() - 1) * std::sqrt(squares / (n - 1) / n);
    return {average, average - half, average + half};
}

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
    std::size_t successes = 0, false_successes = 0;
    std::vector<double> successful;
    for (const MeasuredRun& run : runs) {
        successes += run.success;
        false_successes += run.false_success;
        if (run.success) successful.push_back(run.length);
    }
    result.success = rate(successes, runs.size());
    result.false_success = rate(false_successes, runs.size());
    result.spl_info = spl(runs, [](const MeasuredRun& run) { return run.policy_length; });
    result.spl_omni = spl(runs, [](const MeasuredRun& run) { return run.omniscient_length; });
    result.length_ratio = length_ratio(runs);
    result.length = mean_of(runs, [](const MeasuredRun& run) { return run.length; });
    result.successful_length = mean(successful);
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
