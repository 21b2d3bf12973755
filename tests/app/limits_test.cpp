// Time, memory, signals and places that cannot be written to.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <nlohmann/json.hpp>

#include "tests/app/process.hpp"
#include "tests/app/tasks.hpp"

#ifdef PRAXIS_SANITIZED
constexpr bool kSanitized = true;
constexpr double kTolerance = 3;
#else
constexpr bool kSanitized = false;
/// Beyond the limit's own 100 ms: the test machine may be busy with other tests.
constexpr double kTolerance = 0.6;
#endif

namespace praxis::test {
namespace {

class Limits : public testing::Test {
  protected:
    std::vector<std::string> hard(std::vector<std::string> more,
                                  const std::string& search = "astar(blind())") {
        std::vector<std::string> arguments{domain_of("tiles"), problem, "--search", search};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }

    TemporaryFolder folder;
    std::string problem = folder.write("hard.pddl", hard_tiles_problem());
    std::string report = folder / "report.json";
};

TEST_F(Limits, TimeLimitHolds) {
    const Outcome outcome = plan(hard({"--time-limit", "0.7", "--json", report}));
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
    EXPECT_GE(outcome.seconds, 0.69);
    EXPECT_LT(outcome.seconds, 0.8 + kTolerance);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "time limit")) << outcome.err;
    const auto values = nlohmann::json::parse(read_file(report));
    EXPECT_EQ(values["status"], "out_of_time");
    EXPECT_GT(values["search"]["expanded"], 100);
}

TEST_F(Limits, TinyTimeLimitsHoldInEveryPhase) {
    for (const char* limit : {"0.0001", "0.001", "0.002", "0.005", "0.02", "0.1"}) {
        const Outcome outcome = plan(hard({"--time-limit", limit}));
        EXPECT_EQ(outcome.exit_code, 23) << limit << outcome.err;
        EXPECT_LT(outcome.seconds, std::stod(limit) + 0.1 + kTolerance) << limit;
    }
}

TEST_F(Limits, InputThatNeverEndsMeetsALimit) {
    const Outcome outcome = plan({"validate", domain_of("tiles"), problem, "/dev/zero", "--time-limit", "0.5",
                                  "--memory-limit", "200"});
    EXPECT_TRUE(outcome.exit_code == 23 || outcome.exit_code == 22) << outcome.exit_code << outcome.err;
    EXPECT_LT(outcome.seconds, 0.6 + kTolerance);
}

TEST_F(Limits, ProcessorLimitOfTheSystemIsATimeLimit) {
    const Outcome outcome = plan(hard({}), {.prepare = [] {
                                     const rlimit limit{1, 3};
                                     setrlimit(RLIMIT_CPU, &limit);
                                 }});
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
    EXPECT_FALSE(outcome.killed);
}

TEST_F(Limits, SignalOfTheProcessorLimitIsATimeLimit) {
    const Outcome outcome = plan(hard({}), {.signals = {{0.4, SIGXCPU}}});
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
}

TEST_F(Limits, MemoryLimitHolds) {
    if (kSanitized) GTEST_SKIP() << "sanitizers need memory of their own";
    const Outcome outcome = plan(hard({"--memory-limit", "60", "--time-limit", "50", "--json", report}));
    EXPECT_EQ(outcome.exit_code, 22) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "memory limit")) << outcome.err;
    const auto values = nlohmann::json::parse(read_file(report));
    EXPECT_EQ(values["status"], "out_of_memory");
    EXPECT_LT(values["peak_memory"], 140 << 20);
    EXPECT_GT(values["search"]["expanded"], 100);
}

TEST_F(Limits, AddressSpaceOfTheSystemIsAMemoryLimit) {
    if (kSanitized) GTEST_SKIP() << "sanitizers need address space of their own";
    for (const rlim_t megabytes : {rlim_t{40}, rlim_t{80}}) {
        const Outcome outcome = plan(hard({"--time-limit", "50"}), {.prepare = [megabytes] {
                                         const rlimit limit{megabytes << 20, megabytes << 20};
                                         setrlimit(RLIMIT_AS, &limit);
                                     }});
        EXPECT_EQ(outcome.exit_code, 22) << megabytes << outcome.err;
    }
}

TEST_F(Limits, TasksTooLargeToGroundArePlannedWithout) {
    std::string parameters, objects, conditions, links;
    for (int i = 0; i < 12; ++i) parameters += " ?x" + std::to_string(i);
    for (int i = 0; i < 11; ++i)
        conditions += " (link ?x" + std::to_string(i) + " ?x" + std::to_string(i + 1) + ")";
    for (int i = 0; i < 40; ++i) objects += " o" + std::to_string(i);
    for (int i = 0; i < 11; ++i) links += " (link o" + std::to_string(i) + " o" + std::to_string(i + 1) + ")";
    const std::string domain =
        folder.write("huge-domain.pddl",
                     "(define (domain huge) (:predicates (link ?x ?y) (cut ?x))\n"
                     " (:action tie :parameters (?x ?y) :precondition (not (= ?x ?y)) :effect (link ?x ?y))\n"
                     " (:action cut :parameters (" +
                         parameters + ")\n  :precondition (and" + conditions + ") :effect (cut ?x11)))\n");
    const std::string huge =
        folder.write("huge.pddl", "(define (problem h) (:domain huge) (:objects" + objects + ")\n (:init " +
                                      links + ") (:goal (cut o11)))\n");
    const Outcome outcome = plan({domain, huge, "--time-limit", "2", "--json", report});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "lifted search")) << outcome.err;
    const auto values = nlohmann::json::parse(read_file(report));
    EXPECT_EQ(values["lifted"], true);
    EXPECT_EQ(values["plan"]["length"], 1);
}

TEST_F(Limits, InterruptEndsCleanly) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome outcome = plan(hard({"--json", report}), {.signals = {{0.4, signal}}});
        EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
        EXPECT_FALSE(outcome.killed);
        EXPECT_LT(outcome.seconds, 0.5 + kTolerance);
        EXPECT_EQ(nlohmann::json::parse(read_file(report))["status"], "interrupted");
    }
}

TEST_F(Limits, NothingIsLeftBehind) {
    plan(hard({"--plan-file", folder / "my.plan"}), {.signals = {{0.3, SIGINT}}});
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"hard.pddl"}));
}

TEST_F(Limits, ProgressIsShownAfterASecond) {
    const Outcome outcome = plan(hard({"--time-limit", "1.6"}));
    EXPECT_TRUE(contains(outcome.err, "expanded")) << outcome.err;
    const Outcome quiet = plan(hard({"--time-limit", "1.6", "--quiet"}));
    EXPECT_EQ(quiet.err, "");
    EXPECT_EQ(quiet.exit_code, 23);
}

class Writing : public testing::Test {
  protected:
    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kWalkDomain);
    std::string problem = folder.write("walk1.pddl", kWalkProblem);
};

TEST_F(Writing, UnwritablePlanFileIsAnErrorThatKeepsThePlan) {
    const Outcome outcome = plan({domain, problem, "--plan-file", folder / "no/such/folder/plan"});
    EXPECT_EQ(outcome.exit_code, 35);
    EXPECT_TRUE(contains(outcome.err, "no/such/folder/plan")) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(Writing, UnwritableReportIsAnError) {
    const Outcome outcome = plan({domain, problem, "--json", folder / "no/such/folder/report"});
    EXPECT_EQ(outcome.exit_code, 35);
    EXPECT_TRUE(contains(outcome.err, "report")) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, kWalkPlan));
}

TEST_F(Writing, BrokenPipeIsAnError) {
    const Outcome outcome = plan({domain, problem}, {.close_output = true});
    EXPECT_EQ(outcome.exit_code, 35);
    EXPECT_FALSE(outcome.killed);
    EXPECT_TRUE(contains(outcome.err, "cannot write")) << outcome.err;
}

TEST_F(Writing, FullDiskIsAnError) {
    const Outcome outcome = plan({domain, problem, "--plan-file", "/dev/full"});
    EXPECT_EQ(outcome.exit_code, 35);
    EXPECT_TRUE(contains(outcome.err, "/dev/full")) << outcome.err;
}

}  // namespace
}  // namespace praxis::test
