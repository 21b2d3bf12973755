// `plan validate`, `plan ground`, `plan list`, help and version.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "search/task/sas.hpp"
#include "tests/app/process.hpp"
#include "tests/app/tasks.hpp"

namespace praxis::test {
namespace {

class OtherCommands : public testing::Test {
  protected:
    Outcome validate(const std::string& text) {
        return plan({"validate", domain, problem, folder.write("my.plan", text)});
    }

    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kWalkDomain);
    std::string problem = folder.write("walk1.pddl", kWalkProblem);
};

TEST_F(OtherCommands, ValidPlan) {
    const Outcome outcome = validate(kWalkPlan + "; cost = 3 (unit cost)\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "valid plan: 3 actions, cost 3\n");
}

TEST_F(OtherCommands, PlanFromStandardInput) {
    const Outcome outcome = plan({"validate", domain, problem, "-"}, {.input = kWalkPlan});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(OtherCommands, PlanWithAStepLeftOut) {
    const Outcome outcome = validate("(go a b)\n(go c d)\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.out.starts_with("invalid plan: step 2 (go c d): ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "(at c)")) << outcome.out;
}

TEST_F(OtherCommands, PlanThatStopsShort) {
    const Outcome outcome = validate("(go a b)\n(go b c)\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(outcome.out.starts_with("invalid plan: the goal is not reached: (at d) ")) << outcome.out;
}

TEST_F(OtherCommands, PlanThatClaimsTooLittle) {
    const Outcome outcome = validate(kWalkPlan + "; cost = 2 (unit cost)\n");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_TRUE(contains(outcome.out, "cost")) << outcome.out;
}

TEST_F(OtherCommands, PlanThatIsNone) {
    const Outcome outcome = validate("(go a b)\n(fly b c)\n");
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "my.plan:2:")) << outcome.err;
}

TEST_F(OtherCommands, VerdictInTheReport) {
    const Outcome outcome =
        plan({"validate", domain, problem, folder.write("my.plan", "(go a b)\n(go c d)\n"), "--json",
              folder / "report.json"});
    EXPECT_EQ(outcome.exit_code, 1);
    const auto report = nlohmann::json::parse(read_file(folder / "report.json"));
    EXPECT_EQ(report["status"], "invalid");
    EXPECT_EQ(report["verdict"]["valid"], false);
    EXPECT_EQ(report["verdict"]["failing_step"], 2);
    EXPECT_TRUE(contains(report["message"], "step 2 (go c d): "));
}

TEST_F(OtherCommands, GroundShowsPhasesAndCounts) {
    const Outcome outcome = plan({"ground", domain, problem});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "operators")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "variables")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "MiB")) << outcome.out;
}

TEST_F(OtherCommands, GroundWritesSas) {
    const std::string file = folder / "task.sas";
    ASSERT_EQ(plan({"ground", problem, "--sas", file}).exit_code, 0);
    const FiniteDomainTask task = read_sas({file, read_file(file)});
    EXPECT_EQ(task.goal.size(), 1u);
    EXPECT_EQ(task.operator_count(), 3u);
    const Outcome shown = plan({"ground", domain, problem, "--sas", "-"});
    EXPECT_EQ(shown.out, read_file(file));
}

TEST_F(OtherCommands, GroundWithATimeLimit) {
    const Outcome outcome = plan({"ground", domain, problem, "--time-limit", "0.000001"});
    EXPECT_EQ(outcome.exit_code, 23) << outcome.out;
}

TEST_F(OtherCommands, ListShowsEveryKind) {
    const Outcome all = plan({"list"});
    EXPECT_EQ(all.exit_code, 0) << all.err;
    for (const char* name : {"lmcut(", "ff(", "astar(", "lazy_greedy(", "agile"})
        EXPECT_TRUE(contains(all.out, name)) << name;
    const Outcome evaluators = plan({"list", "evaluators"});
    EXPECT_TRUE(contains(evaluators.out, "admissible: "));
    EXPECT_FALSE(contains(evaluators.out, "astar("));
    EXPECT_TRUE(contains(plan({"list", "engines"}).out, "astar("));
    EXPECT_TRUE(contains(plan({"list", "aliases"}).out, "--search '"));
}

TEST_F(OtherCommands, HelpShowsExamples) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--help"}, {"validate", "--help"}, {"ground", "--help"}, {"list", "-h"}}) {
        const Outcome outcome = plan(arguments);
        EXPECT_EQ(outcome.exit_code, 0);
        EXPECT_TRUE(contains(outcome.out, "Usage:")) << outcome.out;
        EXPECT_TRUE(contains(outcome.out, "Examples:")) << outcome.out;
    }
}

TEST_F(OtherCommands, Version) {
    const Outcome outcome = plan({"--version"});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "praxis " PRAXIS_VERSION "\n");
}

}  // namespace
}  // namespace praxis::test
