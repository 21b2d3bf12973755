#include "practice/experiment/chart.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "practice/experiment/axis.hpp"
#include "practice/experiment/number_text.hpp"
#include "support.hpp"

namespace praxis::practice {
namespace {

using testing::count;
using testing::xml_error;

std::vector<std::string> labels(double low, double high, int wanted) {
    std::vector<std::string> result;
    for (const Tick& tick : round_ticks(low, high, wanted)) result.push_back(tick.label);
    return result;
}

TEST(Axis, TicksAreRound) {
    using Labels = std::vector<std::string>;
    EXPECT_EQ(labels(0, 100, 6), (Labels{"0", "20", "40", "60", "80", "100"}));
    EXPECT_EQ(labels(0, 2500, 7), (Labels{"0", "500", "1,000", "1,500", "2,000", "2,500"}));
    EXPECT_EQ(labels(0, 2'400'000, 6), (Labels{"0.0M", "0.5M", "1.0M", "1.5M", "2.0M"}));
    EXPECT_EQ(labels(0, 250'000, 6), (Labels{"0k", "50k", "100k", "150k", "200k", "250k"}));
    EXPECT_EQ(labels(0, 1, 6), (Labels{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(labels(-1, 1, 5), (Labels{"-1.0", "-0.5", "0.0", "0.5", "1.0"}));
}

TEST(Axis, RefusesWhatIsNoRange) {
    EXPECT_THROW(round_ticks(1, 1, 5), std::invalid_argument);
    EXPECT_THROW(round_ticks(0, std::numeric_limits<double>::infinity(), 5), std::invalid_argument);
    EXPECT_THROW(round_ticks(0, 1, 1), std::invalid_argument);
}

RC_GTEST_PROP(Axis, TicksLieInsideAndAreFew, ()) {
    const double low = *rc::gen::inRange(-1000, 1000);
    const double high = low + *rc::gen::inRange(1, 1'000'000) / 1000.0;
    const std::vector<Tick> ticks = round_ticks(low, high, 6);
    RC_ASSERT(ticks.size() >= 2u && ticks.size() <= 7u);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        RC_ASSERT(ticks[i].value >= low - 1e-6 && ticks[i].value <= high + 1e-6);
        if (i > 0) RC_ASSERT(ticks[i].label != ticks[i - 1].label);
    }
}

TEST(NumberText, IsForPeopleOrExact) {
    EXPECT_EQ(exact(0.1), "0.1");
    EXPECT_EQ(fixed(-0.04, 1), "0.0");
    EXPECT_EQ(fixed(-0.06, 1), "-0.1");
    EXPECT_EQ(fixed(std::numeric_limits<double>::infinity(), 2), "\u221e");
    EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "\u2212\u221e");
    EXPECT_EQ(grouped(999.4), "999");
    EXPECT_EQ(grouped(1234567), "1,234,567");
    EXPECT_EQ(grouped(-1000), "-1,000");
    EXPECT_EQ(grouped(-123), "-123");
    EXPECT_EQ(brief(0.123456), "0.1235");
}

const ChartLine kLine = {"ees", {{0, 0, 0, 0.1}, {500, 0.5, 0.4, 0.6}, {1000, 1, 1, 1}}};

TEST(Chart, DrawsLineAndBandWhereTheyBelong) {
    ChartOptions options;
    options.width = 58 + 100 + 190;  // the plot is 100 wide
    options.height = 34 + 200 + 46;  // and 200 high
    const std::string chart = line_chart({&kLine, 1}, options);
    EXPECT_NE(chart.find("points=\"58.0,234.0 108.0,134.0 158.0,34.0\""), std::string::npos) << chart;
    EXPECT_NE(chart.find("points=\"58.0,214.0 108.0,114.0 158.0,34.0 158.0,34.0 108.0,154.0 58.0,234.0\""),
              std::string::npos)
        << chart;
}

TEST(Chart, IsWellFormedForAnyNames) {
    std::vector<ChartLine> lines;
    for (const std::string& name : testing::hostile_names()) lines.push_back({name, kLine.points});
    for (const std::string& name : testing::hostile_names()) {
        const std::string chart = line_chart(lines, {name, name, name, 760, 400, 0.8});
        EXPECT_EQ(xml_error(chart), "");
        EXPECT_EQ(count(chart, "<script"), 0u);
        EXPECT_EQ(count(chart, "class=\"line\""), 2 * lines.size());  // line and legend
    }
}

RC_GTEST_PROP(Chart, IsWellFormedForAnyBytes, (const std::string& name)) {
    RC_ASSERT(xml_error(line_chart(std::vector<ChartLine>{{name, kLine.points}},
                                   {name, name, name, 760, 400, {}})) == "");
}

TEST(Chart, ManyLinesStayApart) {
    const std::vector<ChartLine> lines(20, kLine);
    const std::string chart = line_chart(lines, {});
    EXPECT_EQ(xml_error(chart), "");
    EXPECT_EQ(count(chart, "<g class=\"c0\">"), 6u);  // lines 0, 7, 14 and their legends
    EXPECT_EQ(count(chart, "stroke-dasharray=\"7 4\""), 14u);
    EXPECT_EQ(chart.find("height=\"400.0\""), std::string::npos);  // the legend needs more
}

TEST(Chart, LongNamesAreShortenedButKept) {
    std::string name;
    for (int i = 0; i < 40; ++i) name += "\u00e9";
    const std::string chart = line_chart(std::vector<ChartLine>{{name, {}}}, {});
    EXPECT_NE(chart.find("<title>" + name), std::string::npos);
    EXPECT_NE(chart.find("\u00e9\u2026</text>"), std::string::npos);
    EXPECT_EQ(xml_error(chart), "");
}

TEST(Chart, LittleOrNoData) {
    EXPECT_NE(line_chart({}, {}).find("no data"), std::string::npos);
    const std::string one = line_chart(std::vector<ChartLine>{{"m", {{0, 0.5, 0.5, 0.5}}}}, {});
    EXPECT_EQ(count(one, "<circle"), 1u);
    EXPECT_EQ(one.find("no data"), std::string::npos);
    EXPECT_EQ(xml_error(one), "");
}

TEST(Chart, RefusesWhatCannotBeDrawn) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(line_chart(std::vector<ChartLine>{{"m", {{infinity, 0, 0, 0}}}}, {}), std::invalid_argument);
    EXPECT_THROW(line_chart(std::vector<ChartLine>{{"m", {{1e300, 0, 0, 0}}}}, {}), std::invalid_argument);
    EXPECT_THROW(line_chart(std::vector<ChartLine>{{"m", {{0, std::nan(""), 0, 0}}}}, {}),
                 std::invalid_argument);
    EXPECT_THROW(line_chart({}, {"", "", "", 10, 400, {}}), std::invalid_argument);
    EXPECT_THROW(line_chart({}, {"", "", "", 760, infinity, {}}), std::invalid_argument);
    EXPECT_THROW(line_chart({}, {"", "", "", 760, 400, infinity}), std::invalid_argument);
}

TEST(Chart, LearningCurvesHaveBandsFromTwoSeedsOn) {
    const std::vector<CurveSummary> one = {{"row", "ees", {{0, {0.5, 0, 1, 1}}, {9, {0.6, 0, 1, 1}}}}};
    const std::vector<CurveSummary> two = {{"row", "ees", {{0, {0.5, 0, 1, 2}}, {9, {0.6, 0, 1, 2}}}}};
    EXPECT_EQ(count(learning_chart("row", one, 0.8), "<polygon"), 0u);
    EXPECT_EQ(count(learning_chart("row", two, 0.8), "<polygon"), 1u);
    EXPECT_EQ(learning_chart("row", two, 0.8), learning_chart("row", two, 0.8));
}

TEST(Chart, LearningCurvesAreThoseOfTheEnvironment) {
    const std::vector<CurveSummary> all = {{"row", "ees", {{0, {0.5, 0.5, 0.5, 1}}}},
                                           {"ring", "ees", {{0, {0.5, 0.5, 0.5, 1}}}},
                                           {"ring", "fail-focus", {{0, {0.6, 0.6, 0.6, 1}}}}};
    EXPECT_EQ(count(learning_chart("row", all, 0.8), "fail-focus"), 0u);
    const std::string ring = learning_chart("ring", all, 0.8);
    EXPECT_EQ(count(ring, "ees"), count(ring, "fail-focus"));
    EXPECT_GT(count(ring, "fail-focus"), 0u);
    EXPECT_NE(ring.find(">ring<"), std::string::npos) << ring;
}

}  // namespace
}  // namespace praxis::practice
