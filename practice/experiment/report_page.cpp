#include "practice/experiment/report_page.hpp"

#include "practice/experiment/chart.hpp"
#include "practice/experiment/curves.hpp"
#include "practice/experiment/report_data.hpp"
#include "practice/experiment/report_page_parts.hpp"
#include "practice/experiment/report_table.hpp"
#include "search/text/markup.hpp"

namespace praxis::practice {

std::string report_page(std::span<const RunResult> runs, const ReportOptions& options) {
    const std::vector<EnvironmentResult> results = compare_methods(runs, options.comparison);
    const std::vector<CurveSummary> summaries = summarise(curves_of(runs), options.comparison.confidence);
    std::string sections;
    std::span<const CurveSummary> rest = summaries;
    for (const EnvironmentResult& result : results) {
        ChartOptions chart;
        chart.title = result.environment;
        chart.x_label = "transitions";
        chart.y_label = "tasks solved";
        chart.mark = options.comparison.threshold.solved;
        sections += "<section>\n<h2>" + escape_markup(result.environment) + "</h2>\n" +
                    learning_chart(rest.first(result.methods.size()), chart) +
                    report_table(result, options.comparison) + "</section>\n";
        rest = rest.subspan(result.methods.size());
    }
    if (results.empty()) sections = "<p>No run is finished.</p>\n";
    return report_page_html(options.title, options.summary, sections, report_data(runs, options));
}

}  // namespace praxis::practice
