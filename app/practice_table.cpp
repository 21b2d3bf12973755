#include "app/practice_table.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "practice/experiment/number_text.hpp"

namespace praxis::app {
namespace {

using namespace praxis::practice;

using Row = std::array<std::string, 5>;

std::string per_cent(double share) {
    return fixed(100 * share, 1);
}

std::string interval(double low, double high, std::string (*text)(double)) {
    return " [" + text(low) + ", " + text(high) + "]";
}

std::string solved(const IntervalEstimate& share) {
    return per_cent(share.value) + " %" +
           (share.count > 1 ? interval(share.low, share.high, per_cent) : std::string());
}

std::string transitions(const ReachedSummary& reached) {
    const IntervalEstimate& mean = reached.mean;
    if (reached.censored == mean.count) return "never within " + grouped(mean.value);
    std::string text = (reached.censored > 0 ? "at least " : "") + grouped(mean.value);
    if (mean.count > 1) text += interval(mean.low, mean.high, grouped);
    if (reached.censored > 0)
        text += ", " + std::to_string(reached.censored) + " of " + std::to_string(mean.count) + " never";
    return text;
}

std::string aligned(const std::vector<Row>& rows) {
    std::array<std::size_t, std::tuple_size_v<Row>> widths{};
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    for (const Row& row : rows) {
        text += " ";
        for (std::size_t i = 0; i < row.size(); ++i) {
            text += " " + row[i];
            if (i + 1 < row.size()) text.append(widths[i] - row[i].size() + 1, ' ');
        }
        text += "\n";
    }
    return text;
}

/// The method other than the reference that needs the least practice; null if there is none.
const MethodResult* best_other(const EnvironmentResult& result) {
    const MethodResult* best = nullptr;
    const auto need = [](const MethodResult& method) {
        return std::pair(method.reached.mean.value, method.reached.censored);
    };
    for (const MethodResult& method : result.methods)
        if (method.against && (best == nullptr || need(method) < need(*best))) best = &method;
    return best;
}

std::string ratio_line(const EnvironmentResult& result, const std::string& level) {
    const MethodResult* other = best_other(result);
    if (other == nullptr) return {};
    const PracticeRatio& ratio = other->against->practice;
    const std::string bound = bound_of(ratio);
    std::string text = "  " + other->method + ", the best of the others, ";
    if (bound == "unclear")
        return text + "cannot be compared: of both, some runs never solve " + level + "\n";
    text += "needs " + (bound.empty() ? "" : bound + " ") + fixed(ratio.value, 2) + " times";
    text += interval(ratio.low, ratio.high, [](double value) { return fixed(value, 2); });
    return text + " the practice of " + result.reference + " to " + level + "\n";
}

std::string section(const EnvironmentResult& result, const std::string& level) {
    std::vector<Row> rows{
        {"method", "runs", "solved at the end", "transitions to " + level, "seconds a run"}};
    for (const MethodResult& method : result.methods)
        rows.push_back({method.method, std::to_string(method.solved.count), solved(method.solved),
                        transitions(method.reached), fixed(method.processor_seconds.value, 3)});
    return result.environment + "\n" + aligned(rows) + ratio_line(result, level);
}

}  // namespace

std::string practice_table(std::span<const EnvironmentResult> results, const ThresholdOptions& threshold,
                           std::size_t runs) {
    const std::string level = brief(100 * threshold.solved) + " %";
    std::size_t finished = 0;
    std::string text;
    for (const EnvironmentResult& result : results) {
        if (!text.empty()) text += "\n";
        text += section(result, level);
        for (const MethodResult& method : result.methods) finished += method.solved.count;
    }
    if (finished == runs) return text;
    if (!text.empty()) text += "\n";
    return text + "Only " + std::to_string(finished) + " of " + std::to_string(runs) +
           " runs are finished.\n";
}

}  // namespace praxis::app
