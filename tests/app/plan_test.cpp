// `plan DOMAIN PROBLEM`: results, exit codes, calling conventions.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"
#include "tests/app/tasks.hpp"

namespace praxis::test {
namespace {

class PlanCommand : public testing::Test {
  protected:
    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kWalkDomain);
    std::string problem = folder.write("walk1.pddl", kWalkProblem);
};

TEST_F(PlanCommand, PrintsThePlanInIpcFormat) {
    const Outcome outcome = plan({domain, problem});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, kWalkPlan + "; cost = 3 (unit cost)\n; Cost: 3\n");
    EXPECT_TRUE(contains(outcome.err, "plan found: 3 actions, cost 3")) << outcome.err;
}

TEST_F(PlanCommand, QuietMeansNothingOnStandardError) {
    const Outcome outcome = plan({domain, problem, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(PlanCommand, VerboseShowsPhasesAndStatistics) {
    const Outcome outcome = plan({domain, problem, "--verbose"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(contains(outcome.err, "configuration: ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "expanded")) << outcome.err;
}

TEST_F(PlanCommand, WritesThePlanFileNamedByAnOption) {
    const Outcome outcome = plan({domain, problem, "--plan-file", folder / "my.plan"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_file(folder / "my.plan"), outcome.out);
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"domain.pddl", "my.plan", "walk1.pddl"}));
}

TEST_F(PlanCommand, WritesThePlanFileNamedAsInCompetitions) {
    const Outcome outcome = plan({domain, problem, folder / "my.plan"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(read_file(folder / "my.plan"), outcome.out);
}

TEST_F(PlanCommand, RemovesPlanFilesOfAnEarlierRun) {
    folder.write("my.plan", "old");
    folder.write("my.plan.1", "old");
    folder.write("my.plan.2", "old");
    const std::string unsolvable = folder.write("walk2.pddl", kCutOffProblem);
    const Outcome outcome = plan({domain, unsolvable, folder / "my.plan"});
    EXPECT_EQ(outcome.exit_code, 10) << outcome.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"domain.pddl", "walk1.pddl", "walk2.pddl"}));
}

TEST_F(PlanCommand, FindsTheDomainBesideTheProblem) {
    const Outcome outcome = plan({problem});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(PlanCommand, SaysWhereItLookedForTheDomain) {
    const TemporaryFolder other;
    const Outcome outcome = plan({other.write("walk1.pddl", kWalkProblem)});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "domain.pddl")) << outcome.err;
}

TEST_F(PlanCommand, ReadsTheProblemFromStandardInput) {
    const Outcome outcome = plan({domain, "-"}, {.input = kWalkProblem});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(PlanCommand, ReadsTheDomainFromStandardInput) {
    const Outcome outcome = plan({"-", problem}, {.input = kWalkDomain});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(PlanCommand, RefusesStandardInputTwice) {
    EXPECT_EQ(plan({"-", "-"}).exit_code, 31);
}

TEST_F(PlanCommand, SaysUnsolvableBeforeSearch) {
    const Outcome outcome = plan({domain, folder.write("walk2.pddl", kCutOffProblem)});
    EXPECT_EQ(outcome.exit_code, 10) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "there is no plan")) << outcome.err;
}

TEST_F(PlanCommand, SaysUnsolvableBySearch) {
    const Outcome outcome = plan({folder.write("keys.pddl", kKeysDomain),
                                  folder.write("keys1.pddl", kKeysProblem), "--search", "astar(blind())"});
    EXPECT_TRUE(outcome.exit_code == 11 || outcome.exit_code == 10) << outcome.exit_code << outcome.err;
    EXPECT_EQ(outcome.out, "");
}

TEST_F(PlanCommand, RunsTheSearchAskedFor) {
    for (const char* search : {"astar(blind())", "astar(lmcut())", "astar(hmax())", "eager_greedy([ff()])",
                               "lazy_greedy([ff()],preferred=[ff()])", "eager_wastar([add()],w=2)"}) {
        const Outcome outcome = plan({domain, problem, "--search", search});
        EXPECT_EQ(outcome.exit_code, 0) << search << outcome.err;
        EXPECT_TRUE(contains(outcome.out, kWalkPlan)) << search;
    }
}

TEST_F(PlanCommand, SameSeedSamePlan) {
    const std::vector<std::string> arguments{domain_of("warehouse"),
                                             problem_of("warehouse", "small"),
                                             "--search",
                                             "lazy_greedy([ff()],randomize_successors=true)",
                                             "--seed",
                                             "17",
                                             "-q"};
    const Outcome first = plan(arguments);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, plan(arguments).out);
}

TEST_F(PlanCommand, WritesAReport) {
    const std::string file = folder / "report.json";
    const Outcome outcome =
        plan({domain, problem, "--search", "astar(lmcut())", "--seed", "7", "--json", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(read_file(file));
    EXPECT_EQ(report["status"], "solved");
    EXPECT_EQ(report["exit_code"], 0);
    EXPECT_EQ(report["command"], "plan");
    EXPECT_EQ(report["domain"], domain);
    EXPECT_EQ(report["problem"], problem);
    EXPECT_EQ(report["configuration"]["seed"], 7);
    EXPECT_EQ(report["configuration"]["search"], "astar(lmcut())");
    EXPECT_EQ(report["plan"]["cost"], 3);
    EXPECT_EQ(report["plan"]["length"], 3);
    EXPECT_EQ(report["plan"]["optimal"], true);
    EXPECT_EQ(report["plan"]["steps"][1], (std::vector<std::string>{"go", "b", "c"}));
    EXPECT_GT(report["search"]["evaluated"], 0);
    EXPECT_GT(report["phases"].size(), 1u);
    EXPECT_GT(report["peak_memory"], 0);
    EXPECT_GT(report["seconds"], 0.0);
}

TEST_F(PlanCommand, WritesTheReportToStandardOutput) {
    const Outcome outcome = plan({domain, problem, "--json", "-", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(nlohmann::json::parse(outcome.out)["status"], "solved");
}

TEST_F(PlanCommand, ReportsFailuresToo) {
    const std::string file = folder / "report.json";
    EXPECT_EQ(plan({domain, folder / "missing.pddl", "--json", file}).exit_code, 31);
    auto report = nlohmann::json::parse(read_file(file));
    EXPECT_EQ(report["status"], "input_error");
    EXPECT_EQ(report["exit_code"], 31);
    EXPECT_TRUE(contains(report["message"], "missing.pddl"));
    EXPECT_EQ(plan({domain, folder.write("walk2.pddl", kCutOffProblem), "--json", file}).exit_code, 10);
    report = nlohmann::json::parse(read_file(file));
    EXPECT_EQ(report["status"], "unsolvable_early");
}

TEST_F(PlanCommand, PlansWithoutTheCheck) {
    const Outcome outcome = plan({domain, problem, "--no-check"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(PlanCommand, CountsCostsOfTheMetric) {
    const Outcome outcome = plan({domain_of("household"), problem_of("household", "small"), "--quiet",
                                  "--search", "astar(blind())", "--json", folder / "report.json"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(read_file(folder / "report.json"));
    EXPECT_TRUE(contains(outcome.out, "; cost = " + report["plan"]["cost"].dump() + " (general cost)\n"))
        << outcome.out;
}

class OwnTasks : public testing::TestWithParam<std::string> {};

TEST_P(OwnTasks, SmallOneIsSolvedByDefault) {
    const Outcome outcome =
        plan({domain_of(GetParam()), problem_of(GetParam(), "small"), "--time-limit", "50"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Outcome check = plan({"validate", domain_of(GetParam()), problem_of(GetParam(), "small"), "-"},
                               {.input = outcome.out});
    EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
}

std::vector<std::string> own_domains() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(PRAXIS_SOURCE_DIR "/domains"))
        if (std::filesystem::exists(entry.path() / "domain.pddl"))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Domains, OwnTasks, testing::ValuesIn(own_domains()), test_name);

}  // namespace
}  // namespace praxis::test
