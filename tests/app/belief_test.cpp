// `plan belief` as its users run it.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/process.hpp"
#include "tests/app/tasks.hpp"

#ifdef PRAXIS_SANITIZED
constexpr double kTolerance = 3;
#else
constexpr double kTolerance = 0.6;
#endif

namespace praxis::test {
namespace {

const std::string kBoxesDomain =
    "(define (domain boxes) (:requirements :typing :contingent) (:types box)\n"
    "  (:predicates (in ?b - box) (have))\n"
    "  (:action look :parameters (?b - box) :observe (in ?b))\n"
    "  (:action take :parameters (?b - box) :precondition (in ?b) :effect (have)))\n";
const std::string kBoxesStart =
    "(define (problem three) (:domain boxes) (:objects b1 b2 b3 - box)\n"
    "  (:init (oneof (in b1) (in b2) (in b3)))\n"
    "  (:goal (have))";
const std::string kBoxesProblem = kBoxesStart + ")\n";

class BeliefCommand : public testing::Test {
  protected:
    Outcome belief(std::vector<std::string> more) {
        std::vector<std::string> arguments{"belief", domain, problem};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return plan(arguments);
    }
    nlohmann::json report() const { return nlohmann::json::parse(read_file(json)); }
    nlohmann::json runs() const { return report()["runs"]; }

    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kBoxesDomain);
    std::string problem = folder.write("three.pddl", kBoxesProblem);
    std::string worlds = folder.write("worlds.pddl",
                                      "(define (problem w) (:hidden (in b1)) (:hidden (in b2))\n"
                                      "  (:hidden (in b3)))\n");
    std::string json = folder / "report.json";
};

/// The lines of a text that are actions.
std::vector<std::string> actions(const std::string& text) {
    std::vector<std::string> result;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("(")) result.push_back(line);
    return result;
}

TEST_F(BeliefCommand, OneRunIsToldStepByStep) {
    const Outcome outcome = belief({"--seeds", "1", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(outcome.out.starts_with("; plan of ")) << outcome.out;
    EXPECT_TRUE(outcome.out.ends_with("; reached\n")) << outcome.out;
    ASSERT_FALSE(actions(outcome.out).empty());
    EXPECT_TRUE(actions(outcome.out).back().starts_with("(take b")) << outcome.out;
}

TEST_F(BeliefCommand, EveryHiddenWorldIsOneRun) {
    const Outcome outcome = belief({"--world", worlds, "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("3 runs: 3 reached the goal (100.0 %)")) << outcome.out;
    const auto values = report();
    EXPECT_EQ(values["command"], "belief");
    EXPECT_EQ(values["status"], "solved");
    EXPECT_EQ(values["exit_code"], 0);
    ASSERT_EQ(values["runs"].size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& run = values["runs"][i];
        EXPECT_EQ(run["world"], i);
        EXPECT_EQ(run["status"], "reached");
        EXPECT_EQ(run["success"], true);
        EXPECT_EQ(run["false_success"], false);
        EXPECT_EQ(run["actions"], run["steps"].size());
        EXPECT_EQ(run["steps"].back(), "(take b" + std::to_string(i + 1) + ")");
        EXPECT_GE(run["plans"], 1);
        EXPECT_GE(run["processor_seconds"], run["search_seconds"]);
    }
}

TEST_F(BeliefCommand, WorldsOfTheProblemAndOfTheFileAreBothTried) {
    const std::string own = folder.write("own.pddl", kBoxesStart + " (:hidden (in b2)))\n");
    const Outcome outcome =
        plan({"belief", domain, own, "--world", worlds, "--world", worlds, "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(runs().size(), 7u);
}

TEST_F(BeliefCommand, SomeOfTheWorldsEvenlySpread) {
    const Outcome outcome = belief({"--world", worlds, "--runs", "2", "--json", json});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    ASSERT_EQ(runs().size(), 2u);
    EXPECT_EQ(belief({"--world", worlds, "--runs", "9", "--json", json}).exit_code, 0);
    EXPECT_EQ(runs().size(), 3u);
}

TEST_F(BeliefCommand, TheSameSeedGivesTheSameRuns) {
    const auto steps = [&](const std::string& seed) {
        belief({"--seeds", "8", "--seed", seed, "--json", json});
        nlohmann::json result;
        for (const auto& run : runs()) result.push_back(run["steps"]);
        return result;
    };
    const auto first = steps("1");
    EXPECT_EQ(first, steps("1"));
    EXPECT_EQ(first.size(), 8u);
    EXPECT_NE(first, steps("2"));
}

TEST_F(BeliefCommand, TheTraceHasALineForEveryEvent) {
    const std::string trace = folder / "trace.jsonl";
    const Outcome outcome = belief({"--world", worlds, "--trace", trace, "--json", json});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::istringstream lines(read_file(trace));
    std::size_t executed = 0, finished = 0;
    for (std::string line; std::getline(lines, line);) {
        const auto event = nlohmann::json::parse(line);
        EXPECT_LT(event["world"], 3);
        const std::string kind = event["event"];
        executed += kind == "executed";
        finished += kind == "finished";
        const std::string text = event.value("text", "");
        EXPECT_TRUE(kind != "executed" || event["action"].get<std::string>().starts_with("(")) << line;
        EXPECT_TRUE(kind != "planned" || event["actions"] >= 1) << line;
        EXPECT_TRUE(kind != "read" || contains(text, "in(b")) << line;
        EXPECT_TRUE(kind != "finished" || text == "reached") << line;
    }
    EXPECT_EQ(finished, 3u);
    std::size_t steps = 0;
    for (const auto& run : runs()) steps += run["steps"].size();
    EXPECT_EQ(executed, steps);
}

TEST_F(BeliefCommand, RunsThatFailMakeTheCommandFail) {
    const std::string blind = folder.write("blind.pddl",
                                           "(define (domain boxes) (:requirements :typing) (:types box)\n"
                                           "  (:predicates (in ?b - box) (have))\n"
                                           "  (:action take :parameters (?b - box) :precondition (in ?b)\n"
                                           "    :effect (and (have) (not (in ?b)))))\n");
    const Outcome outcome = plan({"belief", blind, problem, "--world", worlds, "--json", json});
    EXPECT_EQ(outcome.exit_code, 12) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "0 reached the goal")) << outcome.out;
    const auto values = report();
    EXPECT_EQ(values["status"], "failed");
    EXPECT_EQ(values["runs"][0]["status"], "not found");
    EXPECT_EQ(values["runs"][0]["success"], false);
}

TEST_F(BeliefCommand, AGoalOutOfReachInEveryWorldIsProved) {
    const std::string nothing = folder.write(
        "nothing.pddl",
        "(define (domain boxes) (:requirements :typing :contingent) (:types box)\n"
        "  (:predicates (in ?b - box) (have) (key))\n"
        "  (:action look :parameters (?b - box) :observe (in ?b))\n"
        "  (:action take :parameters (?b - box) :precondition (and (in ?b) (key)) :effect (have)))\n");
    const Outcome outcome = plan({"belief", nothing, problem, "--seeds", "2", "--json", json});
    EXPECT_EQ(outcome.exit_code, 11) << outcome.err;
    EXPECT_EQ(report()["status"], "unsolvable");
    EXPECT_EQ(runs()[0]["status"], "infeasible");
}

TEST_F(BeliefCommand, FailedActionsAreToldAndCounted) {
    const Outcome outcome = belief({"--seeds", "50", "--failures", "0.3", "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    std::size_t failures = 0;
    for (const auto& run : runs()) failures += run.value("failures", 0u);
    EXPECT_GT(failures, 10u);
    bool told = false;
    for (int seed = 0; seed < 20 && !told; ++seed)
        told = contains(belief({"--failures", "0.5", "--seed", std::to_string(seed)}).out, "; failed: (");
    EXPECT_TRUE(told);
    EXPECT_EQ(belief({"--failures", "2"}).exit_code, 31);
}

TEST_F(BeliefCommand, ObjectsAreFoundOnTheWay) {
    const std::string drawers = folder.write(
        "drawers.pddl",
        "(define (domain drawers) (:requirements :adl :typing) (:types thing drawer)\n"
        "  (:predicates (at ?t - thing ?d - drawer) (out ?t - thing) (searched ?d - drawer))\n"
        "  (:action open :parameters (?d - drawer) :effect (searched ?d)\n"
        "    :observe (forall (?t - thing) (at ?t ?d)))\n"
        "  (:action take :parameters (?t - thing ?d - drawer) :precondition (at ?t ?d) :effect (out ?t)))\n");
    const std::string search = folder.write(
        "search.pddl",
        "(define (problem search) (:domain drawers) (:objects d1 d2 - drawer) (:hidden-objects cup - thing)\n"
        "  (:init (oneof (at cup d1) (at cup d2)))\n"
        "  (:goal (and (searched d1) (searched d2) (forall (?t - thing) (out ?t)))))\n");
    const Outcome outcome = plan({"belief", drawers, search, "--json", json});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome.out, ";   found cup\n")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "(take cup d")) << outcome.out;
    EXPECT_EQ(runs()[0]["found"], nlohmann::json::array({"cup"}));
    const Outcome table = plan({"belief", drawers, search, "--seeds", "10", "--failures", "0.2"});
    EXPECT_EQ(table.exit_code, 0) << table.out << table.err;
    EXPECT_TRUE(contains(table.out, "10 reached the goal")) << table.out;
    for (const std::string option : {"--optimum", "--offline"}) {
        const Outcome refused = plan({"belief", drawers, search, option});
        EXPECT_EQ(refused.exit_code, 31);
        EXPECT_TRUE(contains(refused.err, option + " does not go with ':hidden-objects'")) << refused.err;
    }
}

TEST_F(BeliefCommand, TheStepLimitHolds) {
    const Outcome outcome = belief({"--world", worlds, "--max-steps", "1", "--json", json});
    EXPECT_EQ(outcome.exit_code, 12) << outcome.err;
    for (const auto& run : runs()) {
        EXPECT_EQ(run["status"], "step limit");
        EXPECT_EQ(run["steps"].size(), 1u);
    }
}

TEST_F(BeliefCommand, WrongReadingsMayMisleadButAreCounted) {
    const Outcome outcome = belief({"--seeds", "60", "--noise", "0.45", "--max-steps", "3", "--json", json});
    EXPECT_EQ(outcome.exit_code, 12) << outcome.err;
    std::size_t successes = 0, misled = 0;
    for (const auto& run : runs()) {
        EXPECT_FALSE(run["success"] == true && run["false_success"] == true);
        EXPECT_EQ(run["success"] == true || run["false_success"] == true, run["status"] == "reached");
        successes += run["success"] == true;
        misled += run["false_success"] == true;
    }
    EXPECT_LT(successes, 60u);
    EXPECT_TRUE(outcome.out.starts_with("60 runs: " + std::to_string(successes) + " reached the goal"))
        << outcome.out;
    EXPECT_TRUE(contains(outcome.out, ", " + std::to_string(misled) + " believed so wrongly")) << outcome.out;
}

TEST_F(BeliefCommand, AClassicalTaskIsOneWithoutUncertainty) {
    const std::string walk = folder.write("walk.pddl", kWalkDomain);
    const std::string walk1 = folder.write("walk1.pddl", kWalkProblem);
    const Outcome outcome = plan({"belief", walk, walk1, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(actions(outcome.out), (std::vector<std::string>{"(go a b)", "(go b c)", "(go c d)"}));
}

TEST_F(BeliefCommand, AnotherSearch) {
    EXPECT_EQ(belief({"--world", worlds, "--search", "astar(blind())"}).exit_code, 0);
    const Outcome outcome = belief({"--world", worlds, "--search", "astar(nonsense())"});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "nonsense")) << outcome.err;
}

TEST_F(BeliefCommand, WrongUsage) {
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--noise", "0.7"},
                                                  {"--noise", "-0.1"},
                                                  {"--noise", "much"},
                                                  {"--runs", "-1"},
                                                  {"--runs", "1", "--seeds", "1"},
                                                  {"--max-steps", "x"},
                                                  {"--no-such-option"},
                                                  {"one-more", "file"}}) {
        const Outcome outcome = belief(wrong);
        EXPECT_EQ(outcome.exit_code, 31) << wrong[0];
        EXPECT_TRUE(contains(outcome.err, "plan belief --help")) << outcome.err;
        EXPECT_EQ(outcome.out, "") << wrong[0];
    }
    EXPECT_EQ(plan({"belief"}).exit_code, 31);
    const Outcome help = plan({"belief", "--help"});
    EXPECT_EQ(help.exit_code, 0);
    for (const char* option : {"--world", "--runs", "--seeds", "--noise", "--max-steps", "--trace"})
        EXPECT_TRUE(contains(help.out, option)) << option;
}

TEST_F(BeliefCommand, FilesThatAreMissingOrWrong) {
    Outcome outcome = plan({"belief", folder / "no-domain.pddl", problem});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "no-domain.pddl")) << outcome.err;
    outcome = belief({"--world", folder / "no-world.pddl"});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "no-world.pddl")) << outcome.err;
    outcome = belief({"--world", folder.write("wrong.pddl", "(define (problem w)\n (:hidden (in b9)))")});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "wrong.pddl:2:")) << outcome.err;
}

/// What a problem says first that cannot be, and what is told of it.
struct WrongDescription {
    const char* name;
    const char* init;
    const char* told;
};

class DescriptionOfNoState : public BeliefCommand, public testing::WithParamInterface<WrongDescription> {};

TEST_P(DescriptionOfNoState, IsAnError) {
    const std::string wrong = folder.write(
        "wrong.pddl", "(define (problem three) (:domain boxes) (:objects b1 b2 - box)\n  (:init " +
                          std::string(GetParam().init) + ")\n  (:goal (have)))");
    const Outcome outcome = plan({"belief", domain, wrong});
    EXPECT_EQ(outcome.exit_code, 31) << outcome.out << outcome.err;
    EXPECT_TRUE(contains(outcome.err, GetParam().told)) << outcome.err;
}

INSTANTIATE_TEST_SUITE_P(BeliefCommand, DescriptionOfNoState,
                         testing::Values(WrongDescription{"Contradiction",
                                                          "(in b1) (in b2)\n    (oneof (in b1) (in b2))",
                                                          "wrong.pddl:3:5"},
                                         // Each clause can be satisfied, all together cannot.
                                         WrongDescription{"Clauses",
                                                          "(or (in b1) (in b2)) (or (in b1) (not (in b2)))\n"
                                                          "    (or (not (in b1)) (in b2)) "
                                                          "(or (not (in b1)) (not (in b2)))",
                                                          "no first state"}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(BeliefCommand, OtherCommandsPointHere) {
    const Outcome outcome = plan({domain, problem});
    EXPECT_EQ(outcome.exit_code, 34) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "plan belief")) << outcome.err;
}

/// Runs that do not end soon: the sliding tiles without a heuristic, after a look.
class LongBelief : public testing::Test {
  protected:
    std::vector<std::string> arguments(std::vector<std::string> more) {
        std::vector<std::string> result{"belief", domain_of("tiles"), problem, "--search", "astar(blind())"};
        result.insert(result.end(), more.begin(), more.end());
        return result;
    }
    TemporaryFolder folder;
    std::string problem = folder.write("hard.pddl", hard_tiles_problem());
    std::string json = folder / "report.json";
};

TEST_F(LongBelief, TheTimeLimitHolds) {
    const Outcome outcome = plan(arguments({"--time-limit", "0.7", "--json", json}));
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
    EXPECT_LT(outcome.seconds, 0.8 + kTolerance);
    const auto values = nlohmann::json::parse(read_file(json));
    EXPECT_EQ(values["status"], "out_of_time");
    ASSERT_EQ(values["runs"].size(), 1u);
    EXPECT_EQ(values["runs"][0]["status"], "out of time");
}

TEST_F(LongBelief, InterruptsKeepWhatThereIs) {
    for (const int signal : {SIGINT, SIGTERM}) {
        // By then it searches, on a slow machine too.
        const double when = 0.5 + 0.4 * kTolerance;
        const Outcome outcome = plan(arguments({"--json", json}), {.signals = {{when, signal}}});
        EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
        EXPECT_FALSE(outcome.killed);
        EXPECT_LT(outcome.seconds, when + 0.1 + kTolerance);
        const auto values = nlohmann::json::parse(read_file(json));
        EXPECT_EQ(values["status"], "interrupted");
        ASSERT_EQ(values["runs"].size(), 1u);
        EXPECT_EQ(values["runs"][0]["status"], "interrupted");
    }
}

TEST_F(LongBelief, InterruptedBetweenRunsTheFinishedOnesAreReported) {
    const std::string domain = folder.write("domain.pddl", kBoxesDomain);
    const std::string boxes = folder.write("three.pddl", kBoxesProblem);
    const Outcome outcome = plan({"belief", domain, boxes, "--seeds", "100000000", "--json", json, "--quiet"},
                                 {.signals = {{1, SIGINT}}});
    EXPECT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.err.substr(0, 500);
    EXPECT_LT(outcome.seconds, 1.1 + kTolerance);
    const auto values = nlohmann::json::parse(read_file(json));
    ASSERT_GT(values["runs"].size(), 10u);
    EXPECT_EQ(values["runs"][0]["status"], "reached");
}

}  // namespace
}  // namespace praxis::test
