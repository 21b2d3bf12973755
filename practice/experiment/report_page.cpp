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
    for (const EnvironmentResult& result : results)
        sections += "<section>\n<h2>" + escape_markup(result.environment) + "</h2>\n" +
                    learning_chart(result.environment, summaries, options.comparison.threshold.solved) +
                    report_table(result, options.comparison) + "</section>\n";
    if (results.empty()) sections = "<p>No run is finished.</p>\n";
    return report_page_html(options.title, options.summary, sections, report_data(runs, options));
}

}  // namespace praxis::practice
