#include "practice/experiment/report_table.hpp"

#include <cmath>

#include "practice/experiment/number_text.hpp"
#include "search/text/markup.hpp"

namespace praxis::practice {
namespace {

std::string per_cent(double fraction) {
    return fixed(100 * fraction, 1);
}

/// "12.3 [11.0, 13.6]" with each number written by `text`.
template <class Text>
std::string with_interval(const std::string& value, double low, double high, Text text) {
    return value + " <span class=\"quiet\">[" + text(low) + ", " + text(high) + "]</span>";
}

std::string share(const IntervalEstimate& estimate) {
    const std::string value = per_cent(estimate.value) + " %";
    return estimate.count < 2 ? value : with_interval(value, estimate.low, estimate.high, per_cent);
}

std::string practice_needed(const ReachedSummary& reached) {
    const IntervalEstimate& mean = reached.mean;
    if (reached.censored == mean.count) return "not reached within " + grouped(mean.value);
    const std::string value = (reached.censored > 0 ? "at least " : "") + grouped(mean.value);
    return mean.count < 2 ? value : with_interval(value, mean.low, mean.high, grouped);
}

std::string median(const ReachedSummary& reached) {
    return std::isfinite(reached.median) ? grouped(reached.median) : "\u2013";
}

std::string difference(const std::optional<PairedComparison>& solved) {
    if (!solved) return "no common seed";
    const IntervalEstimate& points = solved->difference;
    const std::string value = (points.value > 0 ? "+" : "") + per_cent(points.value);
    if (points.count < 2) return value;
    const std::string seeds = std::to_string(solved->wins) + " : " + std::to_string(solved->losses);
    return with_interval(value + ", " + seeds, points.low, points.high, per_cent);
}

std::string practice_ratio_text(const PracticeRatio& ratio) {
    const auto times = [](double value) { return fixed(value, 2); };
    const std::string bound = bound_of(ratio);
    if (bound == "unclear") return "unclear: both have runs that did not reach it";
    return with_interval((bound.empty() ? "" : bound + " ") + times(ratio.value), ratio.low, ratio.high,
                         times);
}

std::string row(const char* cell, const std::vector<std::string>& texts) {
    std::string result = "<tr>";
    for (const std::string& text : texts) result += std::string("<") + cell + ">" + text + "</" + cell + ">";
    return result + "</tr>\n";
}

}  // namespace

std::string report_table(const EnvironmentResult& result, const ComparisonOptions& options) {
    const std::string threshold = fixed(100 * options.threshold.solved, 0) + " %";
    const bool pooled = options.evaluation_tasks > 0;
    const bool compared = !result.reference.empty() && result.methods.size() > 1;
    const std::string reference = escape_markup(result.reference);

    std::vector<std::string> head = {"method", "runs", "solved at the end"};
    if (pooled) head.push_back("all tasks pooled");
    for (const std::string& name :
         {"transitions to " + threshold, std::string("median"), std::string("runs that reached it"),
          std::string("seconds a run"), std::string("of evaluations")})
        head.push_back(name);
    if (compared) {
        head.push_back("solved against " + reference + ", seeds won : lost");
        head.push_back("transitions to " + threshold + " / those of " + reference);
    }
    std::string rows;
    for (const MethodResult& method : result.methods) {
        const std::size_t runs = method.solved.count;
        std::vector<std::string> cells = {escape_markup(method.method), std::to_string(runs),
                                          share(method.solved)};
        if (pooled) cells.push_back(share(*method.pooled));
        for (const std::string& text :
             {practice_needed(method.reached), median(method.reached),
              std::to_string(runs - method.reached.censored) + " of " + std::to_string(runs),
              fixed(method.processor_seconds.value, 3), fixed(method.evaluation_seconds.value, 3)})
            cells.push_back(text);
        if (compared) {
            cells.push_back(method.against ? difference(method.against->solved) : "");
            cells.push_back(method.against ? practice_ratio_text(method.against->practice) : "");
        }
        rows += row("td", cells);
    }
    return "<table class=\"figures\"><thead>" + row("th", head) + "</thead><tbody>\n" + rows +
           "</tbody></table>\n";
}

}  // namespace praxis::practice
