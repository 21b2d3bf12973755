#include "practice/experiment/chart.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "practice/experiment/axis.hpp"
#include "practice/experiment/number_text.hpp"
#include "search/text/markup.hpp"

namespace praxis::practice {
namespace {

constexpr std::size_t kColours = 7;
constexpr const char* kStyle =
    ".praxis-chart{font:12px system-ui,sans-serif}"
    ".praxis-chart .paper{fill:#fff}.praxis-chart text{fill:#1d2733}.praxis-chart .title{font-weight:600}"
    ".praxis-chart .axis{stroke:#66737f;fill:none}.praxis-chart .grid{stroke:#e4e9ee}"
    ".praxis-chart .mark{stroke:#66737f;stroke-dasharray:5 4}"
    ".praxis-chart .line{fill:none;stroke:var(--c);stroke-width:2;stroke-linejoin:round}"
    ".praxis-chart .dot{fill:var(--c)}.praxis-chart .band{fill:var(--c);fill-opacity:.16}"
    ".praxis-chart .c0{--c:#0072b2}.praxis-chart .c1{--c:#d55e00}.praxis-chart .c2{--c:#009e73}"
    ".praxis-chart .c3{--c:#cc79a7}.praxis-chart .c4{--c:#e69f00}.praxis-chart .c5{--c:#56b4e9}"
    ".praxis-chart .c6{--c:#4d4d4d}"
    "@media(prefers-color-scheme:dark){.praxis-chart .paper{fill:#14191f}.praxis-chart text{fill:#d9e1e8}"
    ".praxis-chart .axis,.praxis-chart .mark{stroke:#93a1ad}.praxis-chart .grid{stroke:#2a343f}"
    ".praxis-chart .c0{--c:#3f9fd8}.praxis-chart .c1{--c:#f0752a}.praxis-chart .c2{--c:#1fbf93}"
    ".praxis-chart .c6{--c:#c4c4c4}}";
constexpr const char* kDashes[] = {"", "7 4", "2 3", "9 3 2 3"};

constexpr double kLeft = 58, kTop = 34, kBottom = 46, kLegend = 190, kLegendLine = 18, kMargin = 14;
constexpr double kLargest = 1e100;        ///< of a point's numbers
constexpr std::size_t kLongestName = 22;  ///< characters of a name that the legend has room for

std::string place(double value) {
    return fixed(value, 1);
}

std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + place(value) + "\"";
}

std::string text_at(double x, double y, const std::string& text, const std::string& more = "") {
    return "<text" + attribute("x", x) + attribute("y", y) + more + ">" + escape_markup(text) + "</text>\n";
}

std::string segment(const char* kind, double x1, double y1, double x2, double y2) {
    return std::string("<line class=\"") + kind + "\"" + attribute("x1", x1) + attribute("y1", y1) +
           attribute("x2", x2) + attribute("y2", y2) + "/>\n";
}

/// At most `kLongestName` characters.
std::string shortened(const std::string& name) {
    const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; };
    if (static_cast<std::size_t>(std::count_if(name.begin(), name.end(), starts_character)) <= kLongestName)
        return name;
    std::size_t characters = 0, at = 0;
    for (; at < name.size(); ++at)
        if (starts_character(name[at]) && ++characters == kLongestName) break;
    return name.substr(0, at) + "\u2026";
}

class Chart {
  public:
    Chart(std::span<const ChartLine> lines, const ChartOptions& options)
        : lines_(lines),
          options_(options),
          height_(std::max(options.height, kTop + kMargin + kLegendLine * static_cast<double>(lines.size()))),
          right_(options.width - kLegend) {
        if (!(options.width >= 300 && options.width <= 1e5 && options.height >= 200 && options.height <= 1e5))
            throw std::invalid_argument(
                "a chart is at least 300 x 200 pixels, and at most 100,000 wide or high");
        for (const ChartLine& line : lines)
            for (const ChartPoint& point : line.points) take_in(point);
        if (options.mark && !std::isfinite(*options.mark))
            throw std::invalid_argument("the marked level of a chart is not finite");
        if (!(x_low_ < x_high_)) x_high_ = x_low_ + 1;
    }

    std::string text() {
        open();
        draw_axes();
        for (std::size_t i = 0; i < lines_.size(); ++i) draw_line(i);
        for (std::size_t i = 0; i < lines_.size(); ++i) draw_legend(i);
        return text_ + "</svg>\n";
    }

  private:
    void take_in(const ChartPoint& point) {
        for (const double value : {point.x, point.y, point.low, point.high})
            if (!(std::abs(value) <= kLargest))
                throw std::invalid_argument("a point of a chart is not finite, or too large");
        x_low_ = std::min(x_low_, point.x);
        x_high_ = std::max(x_high_, point.x);
    }

    double x(double value) const { return kLeft + (value - x_low_) / (x_high_ - x_low_) * (right_ - kLeft); }
    double y(double value) const {
        return kTop + (1 - std::clamp(value, 0.0, 1.0)) * (height_ - kBottom - kTop);
    }
    std::string position(double at, double value) const { return place(x(at)) + "," + place(y(value)); }

    static std::string dash(std::size_t line) {
        const std::string_view dashes = kDashes[line / kColours % std::size(kDashes)];
        return dashes.empty() ? "" : " stroke-dasharray=\"" + std::string(dashes) + "\"";
    }

    void open() {
        const std::string size = place(options_.width) + " " + place(height_);
        text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"praxis-chart\" role=\"img\"" +
                attribute("width", options_.width) + attribute("height", height_) + " viewBox=\"0 0 " + size +
                "\">\n<title>" + escape_markup(options_.title) + "</title><style>" + kStyle +
                "</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n";
        text_ += text_at(kLeft, 20, options_.title, " class=\"title\"");
    }

    void draw_axes() {
        const double bottom = y(0);
        for (const Tick& tick : round_ticks(0, 100, 6)) {
            const double level = y(tick.value / 100);
            text_ += segment("grid", kLeft, level, right_, level);
            text_ += text_at(kLeft - 6, level + 4, tick.label + " %", " text-anchor=\"end\"");
        }
        for (const Tick& tick : round_ticks(x_low_, x_high_, 7)) {
            text_ += segment("axis", x(tick.value), bottom, x(tick.value), bottom + 4);
            text_ += text_at(x(tick.value), bottom + 17, tick.label, " text-anchor=\"middle\"");
        }
        if (options_.mark) text_ += segment("mark", kLeft, y(*options_.mark), right_, y(*options_.mark));
        text_ += "<path class=\"axis\" d=\"M" + place(kLeft) + "," + place(kTop) + "V" + place(bottom) + "H" +
                 place(right_) + "\"/>\n";
        const double middle = (kTop + bottom) / 2;
        text_ += text_at((kLeft + right_) / 2, height_ - 8, options_.x_label, " text-anchor=\"middle\"");
        text_ += text_at(14, middle, options_.y_label,
                         " text-anchor=\"middle\" transform=\"rotate(-90 14.0 " + place(middle) + ")\"");
        const bool nothing = std::all_of(lines_.begin(), lines_.end(),
                                         [](const ChartLine& line) { return line.points.empty(); });
        if (nothing) text_ += text_at((kLeft + right_) / 2, middle, "no data", " text-anchor=\"middle\"");
    }

    void open_group(std::size_t line) {
        text_ += "<g class=\"c" + std::to_string(line % kColours) + "\"><title>" +
                 escape_markup(lines_[line].name) + "</title>\n";
    }

    void draw_line(std::size_t number) {
        const std::vector<ChartPoint>& points = lines_[number].points;
        if (points.empty()) return;
        open_group(number);
        draw_band(points);
        if (points.size() == 1) {
            text_ += "<circle class=\"dot\" r=\"3.5\"" + attribute("cx", x(points[0].x)) +
                     attribute("cy", y(points[0].y)) + "/>\n";
        } else {
            text_ += "<polyline class=\"line\"" + dash(number) + " points=\"";
            for (const ChartPoint& point : points)
                text_ += (&point == points.data() ? "" : " ") + position(point.x, point.y);
            text_ += "\"/>\n";
        }
        text_ += "</g>\n";
    }

    void draw_band(const std::vector<ChartPoint>& points) {
        const auto has_width = [](const ChartPoint& point) { return point.low < point.high; };
        if (std::none_of(points.begin(), points.end(), has_width)) return;
        text_ += "<polygon class=\"band\" points=\"";
        for (const ChartPoint& point : points) text_ += position(point.x, point.high) + " ";
        for (auto point = points.rbegin(); point != points.rend(); ++point)
            text_ += (point == points.rbegin() ? "" : " ") + position(point->x, point->low);
        text_ += "\"/>\n";
    }

    void draw_legend(std::size_t number) {
        const double left = right_ + kMargin;
        const double level = kTop + kLegendLine * (static_cast<double>(number) + 0.5);
        open_group(number);
        text_ +=
            "<path class=\"line\"" + dash(number) + " d=\"M" + place(left) + "," + place(level) + "h22\"/>\n";
        text_ += text_at(left + 28, level + 4, shortened(lines_[number].name)) + "</g>\n";
    }

    std::span<const ChartLine> lines_;
    const ChartOptions& options_;
    double height_, right_;
    double x_low_ = 0, x_high_ = 0;
    std::string text_;
};

}  // namespace

std::string line_chart(std::span<const ChartLine> lines, const ChartOptions& options) {
    return Chart(lines, options).text();
}

std::string learning_chart(const std::string& environment, std::span<const CurveSummary> summaries,
                           double threshold) {
    std::vector<ChartLine> lines;
    for (const CurveSummary& summary : summaries) {
        if (summary.environment != environment) continue;
        ChartLine& line = lines.emplace_back();
        line.name = summary.method;
        for (const auto& [transitions, solved] : summary.points) {
            const bool band = solved.count > 1;
            line.points.push_back({static_cast<double>(transitions), solved.value,
                                   band ? solved.low : solved.value, band ? solved.high : solved.value});
        }
    }
    ChartOptions options;
    options.title = environment;
    options.x_label = "transitions";
    options.y_label = "tasks solved";
    options.mark = threshold;
    return line_chart(lines, options);
}

}  // namespace praxis::practice
