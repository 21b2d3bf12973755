#include "practice/experiment/threshold.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "search/engines/random.hpp"

namespace praxis::practice {
namespace {

std::size_t count_censored(std::span<const Reached> runs) {
    return static_cast<std::size_t>(
        std::count_if(runs.begin(), runs.end(), [](const Reached& run) { return run.censored; }));
}

std::vector<double> amounts(std::span<const Reached> runs) {
    if (runs.empty()) throw std::invalid_argument("no runs to compare");
    std::vector<double> result;
    for (const Reached& run : runs) result.push_back(static_cast<double>(run.transitions));
    return result;
}

double sum(std::span<const double> values) {
    double result = 0;
    for (const double value : values) result += value;
    return result;
}

double resampled_sum(std::span<const double> values, Random& random) {
    double result = 0;
    for (std::size_t i = 0; i < values.size(); ++i) result += values[random.below(values.size())];
    return result;
}

double ratio(double a, double b) {
    if (b == 0) return a == 0 ? 1 : std::numeric_limits<double>::infinity();
    return a / b;
}

}  // namespace

Reached transitions_to(std::span<const CurvePoint> curve, const ThresholdOptions& options) {
    if (curve.empty()) throw std::invalid_argument("a learning curve without points");
    if (!(options.solved >= 0 && options.solved <= 1))
        throw std::invalid_argument("a threshold of solved tasks is a fraction from 0 to 1");
    const auto reaches = [&](const CurvePoint& point) { return point.solved >= options.solved; };
    auto first = std::find_if(curve.begin(), curve.end(), reaches);
    if (options.stays) {
        const auto last_below = std::find_if_not(curve.rbegin(), curve.rend(), reaches);
        first = last_below.base();
    }
    if (first == curve.end()) return {curve.back().transitions, true};
    return {first->transitions, false};
}

ReachedSummary summarise_reached(std::span<const Reached> runs, double confidence) {
    std::vector<double> values = amounts(runs);
    ReachedSummary result;
    result.mean = mean_estimate(values, confidence);
    result.mean.low = std::max(0.0, result.mean.low);
    result.censored = count_censored(runs);
    for (std::size_t i = 0; i < runs.size(); ++i)
        if (runs[i].censored) values[i] = std::numeric_limits<double>::infinity();
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    result.median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    return result;
}

std::string bound_of(const PracticeRatio& ratio) {
    if (ratio.censored_a > 0 && ratio.censored_b > 0) return "unclear";
    if (ratio.censored_a > 0) return "at least";
    return ratio.censored_b > 0 ? "at most" : "";
}

PracticeRatio practice_ratio(std::span<const Reached> a, std::span<const Reached> b,
                             const BootstrapOptions& options) {
    if (!(options.confidence > 0 && options.confidence < 1) || options.resamples < 1)
        throw std::invalid_argument("a bootstrap needs a confidence between 0 and 1, and resamples");
    const std::vector<double> of_a = amounts(a), of_b = amounts(b);
    const double balance = static_cast<double>(b.size()) / static_cast<double>(a.size());
    PracticeRatio result;
    result.value = ratio(sum(of_a) * balance, sum(of_b));
    result.censored_a = count_censored(a);
    result.censored_b = count_censored(b);

    Random random(options.seed);
    std::vector<double> ratios(static_cast<std::size_t>(options.resamples));
    for (double& value : ratios) {
        const double top = resampled_sum(of_a, random);
        value = ratio(top * balance, resampled_sum(of_b, random));
    }
    std::sort(ratios.begin(), ratios.end());
    const double tail = (1 - options.confidence) / 2 * static_cast<double>(ratios.size());
    const auto cut = std::min(static_cast<std::size_t>(tail), (ratios.size() - 1) / 2);
    result.low = ratios[cut];
    result.high = ratios[ratios.size() - 1 - cut];
    return result;
}

}  // namespace praxis::practice
