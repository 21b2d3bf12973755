// Learning curves as a drawing: lines with confidence bands, a legend and axes, as SVG text.
//
// The drawing stands alone or inside of a page, and follows the reader's light or dark mode. Colours are
// those of Okabe and Ito (2008), which colour-blind readers can tell apart; from the eighth line on, dashes
// tell lines of one colour apart. The same input gives the same text.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "practice/experiment/curves.hpp"

namespace praxis::practice {

struct ChartPoint {
    double x = 0, y = 0;
    double low = 0, high = 0;  ///< the band; without one both equal y
};

struct ChartLine {
    std::string name;  ///< any text
    std::vector<ChartPoint> points;
};

struct ChartOptions {
    std::string title, x_label, y_label;  ///< any text
    double width = 760, height = 400;     ///< in pixels; the height grows with a long legend
    std::optional<double> mark;           ///< a level of y that is marked by a dashed line
};

/// The x axis starts at 0 or below and ends at the largest x; y goes from 0 to 1 and is labelled in per cent.
/// Parts of lines outside of it are cut. Throws std::invalid_argument for numbers that are not finite or a
/// size below 300 x 200.
std::string line_chart(std::span<const ChartLine> lines, const ChartOptions& options);

/// The mean curves of one environment, of those given: tasks solved by transitions, with the environment's
/// name above, bands from two seeds on, and `threshold` (a share of tasks) marked.
std::string learning_chart(const std::string& environment, std::span<const CurveSummary> summaries,
                           double threshold);

}  // namespace praxis::practice
