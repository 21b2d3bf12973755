// `plan practice` as its users run it.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <utility>

#include "tests/app/process.hpp"
#include "tests/practice/experiment/support.hpp"

namespace praxis::test {
namespace {

using practice::testing::count;
using practice::testing::xml_error;

class PracticeCommand : public testing::Test {
  protected:
    /// A small experiment with more options; they replace those of the same name.
    Outcome practice(const std::vector<std::string>& more) {
        static const std::vector<std::pair<std::string, std::string>> kSmall = {
            {"--methods", "ees,fail-focus"}, {"--seeds", "2"},      {"--cycles", "2"},
            {"--cycle-steps", "12"},         {"--test-tasks", "4"}, {"--threads", "2"}};
        std::vector<std::string> arguments{"practice", "light-switch(cells=4)"};
        for (const auto& [name, value] : kSmall)
            if (std::find(more.begin(), more.end(), name) == more.end())
                arguments.insert(arguments.end(), {name, value});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return plan(arguments);
    }

    TemporaryFolder folder;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST_F(PracticeCommand, TheTableHasALineForEachMethod) {
    const Outcome outcome = practice({});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::vector<std::string> lines = lines_of(outcome.out);
    ASSERT_EQ(lines.size(), 5u) << outcome.out;
    EXPECT_EQ(lines[0], "light-switch(cells=4)");
    EXPECT_TRUE(contains(lines[1], "transitions to 80 %"));
    EXPECT_TRUE(lines[2].starts_with("  ees "));
    EXPECT_TRUE(lines[3].starts_with("  fail-focus "));
    EXPECT_TRUE(lines[4].starts_with("  fail-focus, the best of the others, "));
    EXPECT_EQ(lines[2].find(" 2 "), lines[3].find(" 2 ")) << "columns should be aligned";
}

TEST_F(PracticeCommand, TheThresholdIsInTheTable) {
    const Outcome outcome = practice({"--threshold", "0"});
    EXPECT_TRUE(contains(outcome.out, "transitions to 0 %")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "needs 1.00 times [1.00, 1.00] the practice of ees")) << outcome.out;
}

TEST_F(PracticeCommand, FilesAreWellFormed) {
    const Outcome outcome = practice({"--csv", folder / "c.csv", "--summary", folder / "s.csv", "--svg",
                                      folder / "c.svg", "--report", folder / "r.html", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const std::vector<std::string> curves = lines_of(read_file(folder / "c.csv"));
    ASSERT_EQ(curves.size(), 1 + 2 * 2 * 3u);
    EXPECT_EQ(curves[0], "environment,method,seed,cycle,transitions,solved");
    EXPECT_TRUE(curves[1].starts_with("light-switch(cells=4),ees,0,0,0,")) << curves[1];
    EXPECT_TRUE(read_file(folder / "s.csv").starts_with("environment,method,transitions,mean,low,high,n\n"));
    const std::string svg = read_file(folder / "c.svg"), page = read_file(folder / "r.html");
    EXPECT_EQ(xml_error(svg), "");
    EXPECT_TRUE(contains(svg, "fail-focus"));
    EXPECT_EQ(xml_error(page), "");
    EXPECT_TRUE(contains(page, "4 of 4 runs; 2 cycles, 4 tasks a test"));
}

TEST_F(PracticeCommand, SeveralEnvironmentsAreDrawnInFilesOfTheirOwn) {
    const Outcome outcome = practice({"ball-ring(features=relative)", "--svg", folder / "c.svg"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(folder.names(),
              (std::vector<std::string>{"c-ball-ring-features-relative.svg", "c-light-switch-cells-4.svg"}));
    EXPECT_EQ(xml_error(read_file(folder / "c-light-switch-cells-4.svg")), "");
}

TEST_F(PracticeCommand, OneResultCanGoToStandardOutput) {
    const Outcome outcome = practice({"--csv", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(lines_of(outcome.out).size(), 1 + 2 * 2 * 3u) << "and no table";
    EXPECT_EQ(practice({"--csv", "-", "--json", "-"}).exit_code, 31);
}

TEST_F(PracticeCommand, TheReportHasTheFigures) {
    const Outcome outcome = practice({"--json", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["status"], "practised");
    const auto& figures = report["practice"];
    EXPECT_EQ(figures["runs"], 4);
    EXPECT_EQ(figures["finished"], 4);
    EXPECT_EQ(figures["threshold"], 0.8);
    ASSERT_EQ(figures["environments"].size(), 1u);
    const auto& methods = figures["environments"][0]["methods"];
    ASSERT_EQ(methods.size(), 2u);
    EXPECT_EQ(methods[0]["method"], "ees");
    EXPECT_EQ(methods[0]["runs"], 2);
    EXPECT_LE(methods[0]["solved"]["mean"], methods[0]["solved"]["high"]);
    EXPECT_GE(methods[0]["transitions"]["censored"], 0);
    EXPECT_FALSE(methods[0].contains("practice_ratio"));
    EXPECT_TRUE(methods[1]["practice_ratio"].contains("bound"));
}

TEST_F(PracticeCommand, TheSameSeedsGiveTheSameCurves) {
    const std::string first = practice({"--csv", "-"}).out;
    EXPECT_EQ(practice({"--csv", "-", "--threads", "1"}).out, first);
    EXPECT_NE(practice({"--csv", "-", "--seed", "1"}).out, first);
}

TEST_F(PracticeCommand, AnInterruptedExperimentGoesOn) {
    const std::vector<std::string> arguments{
        "practice", "light-switch(cells=30)", "--seeds", "200",       "--cycles",
        "2",        "--test-tasks",           "5",       "--results", folder / "results",
        "--csv",    folder / "c.csv"};
    Circumstances interrupted;
    interrupted.signals = {{0, SIGINT}};
    interrupted.ready = [&] {  // the first run is finished
        std::error_code none;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "results", none))
            if (entry.path().filename().string().ends_with(".0.json")) return true;
        return false;
    };
    const Outcome outcome = plan(arguments, interrupted);
    if (outcome.exit_code == 0) GTEST_SKIP() << "the machine is too fast to be interrupted";
    EXPECT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.err;
    EXPECT_FALSE(outcome.killed);
    EXPECT_TRUE(contains(outcome.err, "stopped by a signal")) << outcome.err;
    const std::size_t kept = lines_of(read_file(folder / "c.csv")).size() / 3;
    ASSERT_GT(kept, 0u) << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "Only " + std::to_string(kept) + " of 200 runs are finished.\n"))
        << outcome.out;

    std::vector<std::string> fewer = arguments;
    fewer[3] = std::to_string(kept / 2 + 1);
    fewer.insert(fewer.end(), {"--verbose"});
    const Outcome again = plan(fewer);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(count(again.err, ", seed 0:"), 0u) << "the first run should not be made again";
    const std::string curves = read_file(folder / "c.csv");
    for (auto& argument : fewer)
        if (argument == folder / "results") argument = folder / "others";
    EXPECT_EQ(plan(fewer).exit_code, 0);
    EXPECT_EQ(read_file(folder / "c.csv"), curves) << "as without an interruption";
}

TEST_F(PracticeCommand, TheTimeLimitLeavesWhatIsFinished) {
    nlohmann::json report;
    for (double limit = 0.5; limit < 30; limit *= 2) {  // until some runs are finished in time
        const Outcome outcome =
            plan({"practice", "light-switch(cells=10)", "--seeds", "100000", "--cycles", "1", "--test-tasks",
                  "1", "--time-limit", std::to_string(limit), "--json", folder / "j"});
        ASSERT_EQ(outcome.exit_code, 23) << outcome.err;
        EXPECT_TRUE(contains(outcome.out, " of 100000 runs are finished.")) << outcome.out;
        report = nlohmann::json::parse(read_file(folder / "j"));
        if (report["practice"]["finished"] > 0) break;
    }
    EXPECT_EQ(report["status"], "out_of_time");
    EXPECT_GT(report["practice"]["finished"], 0);
    EXPECT_LT(report["practice"]["finished"], 100000);
}

TEST_F(PracticeCommand, WhereNothingIsFinishedItSaysSo) {
    const Outcome outcome =
        plan({"practice", "light-switch(cells=1000)", "--time-limit", "0.1", "--csv", folder / "c.csv"});
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
    EXPECT_EQ(outcome.out, "Only 0 of 10 runs are finished.\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{}) << "no file of nothing";
}

TEST_F(PracticeCommand, ResultsOfOtherSettingsAreRefused) {
    EXPECT_EQ(practice({"--results", folder / "r"}).exit_code, 0);
    EXPECT_EQ(practice({"--results", folder / "r", "--methods", "ees,skill-diversity"}).exit_code, 0);
    const Outcome other = practice({"--results", folder / "r", "--epsilon", "0.2"});
    EXPECT_EQ(other.exit_code, 31);
    EXPECT_TRUE(contains(other.err, "was made with other settings")) << other.err;
}

TEST_F(PracticeCommand, TheListNamesEveryPart) {
    const Outcome outcome = plan({"practice", "--list"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"Environments\n  light-switch(cells=100)\n", "\n  playroom\n",
                             "\nMethods\n  ees\n", "\n  task-repeat\n", "\nCompetence models\n  beta\n",
                             "\n  latent\n", "\nClassifiers\n  mlp\n", "\n  ensemble\n"})
        EXPECT_TRUE(contains(outcome.out, part)) << part;
    EXPECT_EQ(outcome.err, "");
}

TEST_F(PracticeCommand, WrongOptionsSayWhatThereIs) {
    const auto refusal = [](const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"practice"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = plan(arguments);
        EXPECT_EQ(outcome.exit_code, 31) << outcome.out;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_TRUE(contains(refusal({}), "there are: light-switch, ball-ring"));
    EXPECT_TRUE(contains(refusal({"attic"}), "there are light-switch, ball-ring"));
    EXPECT_TRUE(contains(refusal({"ball-ring(features=odd)"}), "'raw' or 'relative'"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--methods", "ees,fail-focis"}), "did you mean 'fail-focus'?"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--methods", ""}), "there is no method ''"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--competence", "gamma"}), "beta, optimistic, latent"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--classifier", "tree"}), "mlp, knn, ensemble"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--features", "some"}), "all, relevant, selected"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--exploration", "x"}), "epsilon-greedy, uncertain"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--candidates", "x"}), "tried, all"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--prior", "1"}), "such as 10,1"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--prior", "1,nan"}), "such as 10,1"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--epsilon", "nan"}), "from 0 to 1"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--threshold", "2"}), "from 0 to 1"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--seeds", "0"}), "from 1 to"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--score-every", "0"}), "from 1 to"));
    EXPECT_TRUE(contains(refusal({"kitchen", "--cycles", "99999999999999"}), "from 0 to"));
    EXPECT_TRUE(contains(refusal({"kitchen", "playroom", "--svg", "-"}), "--svg needs a name"));
    EXPECT_TRUE(contains(refusal({"kitchen", "kitchen"}), "named twice"));
}

TEST_F(PracticeCommand, FilesThatCannotBeWrittenAreReported) {
    const Outcome outcome = practice({"--csv", folder / "none" + "/c.csv"});
    EXPECT_EQ(outcome.exit_code, 35) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "c.csv")) << outcome.err;
}

TEST_F(PracticeCommand, HelpTellsOptionsAndExamples) {
    const Outcome outcome = plan({"practice", "--help"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* part : {"--results DIR", "--prior A,B", "--no-reset", "Examples:", "Exit codes:"})
        EXPECT_TRUE(contains(outcome.out, part)) << part;
}

}  // namespace
}  // namespace praxis::test
