#include "practice/experiment/report_page.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "practice/experiment/comparison.hpp"
#include "practice/experiment/report_data.hpp"
#include "support.hpp"

namespace praxis::practice {
namespace {

using testing::count;
using testing::example_run;
using testing::xml_error;

/// A run with the curve 0, then `solved` at 100, 200, ...
RunResult run_of(const std::string& method, std::uint64_t seed, const std::vector<double>& solved) {
    RunResult run{"row", method, seed, {{0, 0, 0}}, {}, static_cast<double>(seed), 0.5};
    for (const double fraction : solved) {
        const int cycle = static_cast<int>(run.curve.size());
        run.curve.push_back({cycle, 100 * cycle, fraction});
    }
    return run;
}

const std::vector<RunResult> kRuns = {
    run_of("ees", 1, {0.8, 0.9, 1.0}),
    run_of("ees", 2, {0.5, 0.8, 0.9}),
    run_of("random", 1, {0.1, 0.2, 0.8}),
    run_of("random", 2, {0.1, 0.2, 0.3}),
};

TEST(Comparison, ByHand) {
    const auto results = compare_methods(kRuns, {});
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results[0].environment, "row");
    EXPECT_EQ(results[0].reference, "ees");
    ASSERT_EQ(results[0].methods.size(), 2u);
    const MethodResult& ees = results[0].methods[0];
    const MethodResult& random = results[0].methods[1];
    EXPECT_NEAR(ees.solved.value, 0.95, 1e-12);
    EXPECT_FALSE(ees.pooled);
    EXPECT_FALSE(ees.against);
    EXPECT_NEAR(ees.reached.mean.value, 150, 1e-9);  // 100, 200
    EXPECT_EQ(random.reached.censored, 1u);
    EXPECT_NEAR(random.reached.mean.value, 300, 1e-9);
    EXPECT_NEAR(random.processor_seconds.value, 1.5, 1e-12);
    EXPECT_NEAR(random.evaluation_seconds.value, 0.5, 1e-12);
    ASSERT_TRUE(random.against);
    EXPECT_NEAR(random.against->practice.value, 2, 1e-12);
    EXPECT_EQ(bound_of(random.against->practice), "at least");
    ASSERT_TRUE(random.against->solved);
    EXPECT_NEAR(random.against->solved->difference.value, -0.4, 1e-12);  // -0.2, -0.6
    EXPECT_EQ(random.against->solved->losses, 2u);
}

TEST(Comparison, PoolsTasksIfTheirNumberIsKnown) {
    ComparisonOptions options;
    options.evaluation_tasks = 10;
    const auto results = compare_methods(kRuns, options);
    EXPECT_EQ(*results[0].methods[0].pooled, proportion_estimate(19, 20));
    options.evaluation_tasks = -1;
    EXPECT_THROW(compare_methods(kRuns, options), std::invalid_argument);
}

TEST(Comparison, AnotherReference) {
    ComparisonOptions options;
    options.reference = "random";
    const auto results = compare_methods(kRuns, options);
    EXPECT_FALSE(results[0].methods[1].against);
    EXPECT_NEAR(results[0].methods[0].against->practice.value, 0.5, 1e-12);
    EXPECT_EQ(bound_of(results[0].methods[0].against->practice), "at most");
    options.reference = "none such";
    const auto without = compare_methods(kRuns, options);
    EXPECT_EQ(without[0].reference, "");
    EXPECT_FALSE(without[0].methods[0].against);
}

TEST(Comparison, OnlyCommonSeedsArePaired) {
    std::vector<RunResult> runs = kRuns;
    runs[3].seed = 9;
    EXPECT_EQ(compare_methods(runs, {})[0].methods[1].against->solved->difference.count, 1u);
    runs[2].seed = 8;
    EXPECT_FALSE(compare_methods(runs, {})[0].methods[1].against->solved);
    runs[3].seed = 8;
    EXPECT_THROW(compare_methods(runs, {}), std::invalid_argument);  // twice
}

TEST(ReportPage, ShowsFiguresAndChart) {
    ReportOptions options;
    options.title = "Tonight";
    options.summary = "4 runs";
    options.comparison.evaluation_tasks = 10;
    const std::string page = report_page(kRuns, options);
    EXPECT_EQ(xml_error(page), "");
    for (const char* part :
         {"<h1>Tonight</h1>", "4 runs", "<svg ", "95.0 % <span", "at least 300", "2 of 2", "1 of 2",
          "transitions to 80 %", "at least 2.00 <span", "-40.0, 0 : 2 <span", "all tasks pooled"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(count(page, "http"), count(page, "http://www.w3.org/2000/svg"));  // nothing is loaded
}

TEST(ReportPage, SaysWhatWasNeverReached) {
    const std::vector<RunResult> runs = {run_of("ees", 1, {0.1, 0.2})};
    const std::string page = report_page(runs, {});
    EXPECT_NE(page.find("not reached within 200"), std::string::npos);
    EXPECT_NE(page.find("0 of 1"), std::string::npos);
    EXPECT_EQ(xml_error(page), "");
}

TEST(ReportPage, WithoutRuns) {
    const std::string page = report_page({}, {});
    EXPECT_EQ(xml_error(page), "");
    EXPECT_NE(page.find("No run is finished"), std::string::npos);
}

TEST(ReportPage, HostileNamesStayText) {
    std::vector<RunResult> runs;
    for (const std::string& name : testing::hostile_names()) {
        runs.push_back(example_run(name, name, 1));
        runs.back().choices[0].chosen = runs.back().choices[0].candidates[0].skill = name;
        runs.push_back(example_run(name, name + "2", 1));
    }
    ReportOptions options;
    options.title = options.summary = "</title><script>alert(1)</script>";
    const std::string page = report_page(runs, options);
    EXPECT_EQ(xml_error(page), "");
    EXPECT_EQ(count(page, "<script"), 2u);
    EXPECT_EQ(count(page, "</script"), 2u);
    const auto data = nlohmann::json::parse(report_data(runs, options));
    ASSERT_EQ(data["runs"].size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); i += 2)
        EXPECT_EQ(data["runs"][i]["choices"][0]["chosen"], runs[i].environment);
}

TEST(ReportData, TellsTheFirstChoiceOfEachCycle) {
    const RunResult run = example_run("row", "ees", 456, 3, 3);
    const auto data = nlohmann::json::parse(report_data({&run, 1}, {}));
    ASSERT_EQ(data["runs"].size(), 1u);
    const auto& shown = data["runs"][0];
    EXPECT_EQ(shown["name"], "row, ees, seed 456");
    ASSERT_EQ(shown["choices"].size(), 3u);
    EXPECT_EQ(shown["cycles"], 3);
    const auto& second = shown["choices"][1];
    EXPECT_EQ(second["cycle"], 2);
    EXPECT_EQ(second["transitions"], 107);
    EXPECT_NEAR(second["solved"].get<double>(), 0.4167, 1e-9);
    EXPECT_EQ(second["chosen"], "(place ring table2)");
    EXPECT_EQ(second["left"], 0);
    ASSERT_EQ(second["rows"].size(), 3u);
    EXPECT_EQ(shown["skills"][second["rows"][0][0].get<std::size_t>()], "(place ring table0)");
    EXPECT_EQ(second["rows"][0], nlohmann::json::parse("[0,-1.5,0.3,0.8,4.25,2,2]"));
    EXPECT_EQ(second["rows"][2][1], "\u2212\u221e");
}

TEST(ReportData, LeavesOutWhatIsTooMuchAndSaysSo) {
    std::vector<RunResult> runs;
    for (const std::uint64_t seed : {9u, 3u, 7u}) runs.push_back(example_run("row", "ees", seed, 40, 50));
    runs[1].choices[0].chosen = "(place ring table30)";
    ReportOptions options;
    options.cycles_shown = 5;
    options.candidates_shown = 4;
    const auto data = nlohmann::json::parse(report_data(runs, options));
    ASSERT_EQ(data["runs"].size(), 1u);
    EXPECT_EQ(data["left"], 2);
    const auto& shown = data["runs"][0];
    EXPECT_EQ(shown["name"], "row, ees, seed 3");
    EXPECT_EQ(shown["cycles"], 40);
    std::vector<int> cycles;
    for (const auto& choice : shown["choices"]) cycles.push_back(choice["cycle"]);
    EXPECT_EQ(cycles, (std::vector<int>{1, 10, 20, 30, 40}));
    ASSERT_EQ(shown["choices"][0]["rows"].size(), 5u);  // four, and the chosen one
    EXPECT_EQ(shown["choices"][0]["left"], 45);
    EXPECT_EQ(shown["skills"].size(), 8u);  // four, 30, and those chosen in cycles 10, 20 and 40
}

TEST(ReportPage, LargeExperimentsStaySmall) {
    std::vector<RunResult> runs;
    for (std::uint64_t seed = 0; seed < 6; ++seed)
        for (const char* method : {"ees", "random", "fail-focus"})
            runs.push_back(example_run("row", method, seed, 200, 60));
    EXPECT_LT(report_page(runs, {}).size(), 400'000u);
}

TEST(ReportData, ChoicesWithoutCandidates) {
    RunResult run = example_run("row", "random-skills", 1, 2, 0);
    const auto data = nlohmann::json::parse(report_data({&run, 1}, {}));
    EXPECT_EQ(data["runs"][0]["choices"][0]["chosen"], "");
    EXPECT_EQ(data["runs"][0]["choices"][0]["rows"].size(), 0u);
    run.choices.clear();
    EXPECT_EQ(nlohmann::json::parse(report_data({&run, 1}, {}))["runs"][0]["choices"].size(), 0u);
    EXPECT_EQ(xml_error(report_page({&run, 1}, {})), "");
}

}  // namespace
}  // namespace praxis::practice
