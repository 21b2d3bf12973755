// `plan refine`, end to end.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/app/process.hpp"

#ifdef PRAXIS_SANITIZED
constexpr double kTolerance = 10;
#else
constexpr double kTolerance = 1;
#endif

namespace praxis::test {
namespace {

using nlohmann::json;

const std::string kDomain = PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/domain.pddl";

constexpr const char* kProblem =
    "(define (problem carry) (:domain pick-place)\n"
    "  (:objects can - body p - pose left right - region)\n"
    "  (:init (hand-empty) (graspable can) (pose-of can p) (at can p) (placeable can right))\n"
    "  (:goal (in can right)))\n";

constexpr const char* kScene =
    "robot: {builtin: arm7, start: {arm: ready, gripper: open}}\n"
    "bodies:\n"
    "  - {name: table, box: [0.5, 1, 0.1], pose: {xyz: [0.6, 0, 0.1]}}\n"
    "  - {name: can, box: [0.04, 0.04, 0.15], movable: true, on: table, at: [-0.05, 0.25]}\n"
    "surfaces:\n"
    "  - {name: table, body: table}\n"
    "regions:\n"
    "  - {name: left, surface: table, center: [0, 0.25], size: [0.3, 0.3]}\n"
    "  - {name: right, surface: table, center: [0, -0.25], size: [0.3, 0.3]}\n";

std::string with(std::string text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return text.replace(at, part.size(), other);
}

/// Without the lines of progress, "[   1.0 s, 70 MiB] join", which slow machines see.
std::string without_progress(const std::string& text) {
    return std::regex_replace(text, std::regex("\\[ *[0-9.]+ s, [0-9]+ MiB\\][^\n]*\n"), "");
}

class Refine : public testing::Test {
  protected:
    static Outcome refine(std::vector<std::string> arguments, const Circumstances& circumstances = {}) {
        arguments.insert(arguments.begin(), "refine");
        return plan(arguments, circumstances);
    }
    Outcome carry(const std::vector<std::string>& more = {}, const Circumstances& circumstances = {}) const {
        std::vector<std::string> arguments{kDomain, problem, scene};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return refine(arguments, circumstances);
    }

    static void refused(const Outcome& outcome, const std::string& part, int exit_code = 31) {
        EXPECT_EQ(outcome.exit_code, exit_code) << part << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "") << part;
        EXPECT_TRUE(contains(outcome.err, part)) << "'" << part << "' in: " << outcome.err;
        EXPECT_LT(outcome.err.size(), 20000u);
    }
    void scene_refused(const std::string& text, const std::string& part) const {
        refused(refine({kDomain, problem, folder.write("other.yaml", text)}), part);
    }
    void problem_refused(const std::string& text, const std::string& part) const {
        refused(refine({kDomain, folder.write("other.pddl", text), scene}), part);
    }
    void streams_refused(const std::string& text, const std::string& part) const {
        refused(carry({"--streams", folder.write("other-streams.pddl", text)}), part);
    }
    static std::string streams() {
        return read_file(PRAXIS_SOURCE_DIR "/domains/tamp/pick-place/streams.pddl");
    }

    TemporaryFolder folder;
    std::string problem = folder.write("problem.pddl", kProblem);
    std::string scene = folder.write("scene.yaml", kScene);
    std::string report = folder / "report.json";
};

/// A problem that takes longer than any test waits.
class LongRefine : public Refine {
  protected:
    void SetUp() override {
        const Outcome made =
            refine({"--generate", "packing", "--size", "6", "--infeasible", folder / "long"});
        ASSERT_EQ(made.exit_code, 0) << made.err;
        problem = folder / "long/problem.pddl";
        scene = folder / "long/scene.yaml";
    }
};

TEST_F(Refine, PrintsThePlan) {
    const Outcome outcome = carry();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(without_progress(outcome.err), "");
    EXPECT_TRUE(outcome.out.starts_with("(pick can p #")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n(place can #")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "; 0.000 to ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n; cost = ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "\n; motion = ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, " = grasp ")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, " = pose ")) << outcome.out;
    EXPECT_EQ(carry().out, outcome.out);
}

TEST_F(Refine, VerboseTellsThePhases) {
    const Outcome outcome = carry({"--verbose"});
    for (const char* part :
         {"bind: ", "refine: ", "join: ", "schedule: ", "validate: ", "configurations checked"})
        EXPECT_TRUE(contains(outcome.err, part)) << part << " in: " << outcome.err;
    EXPECT_EQ(carry({"--quiet"}).err, "");
}

TEST_F(Refine, ReportsAsJson) {
    const Outcome outcome = carry({"--json", report});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json values = json::parse(read_file(report));
    EXPECT_EQ(values["command"], "refine");
    EXPECT_EQ(values["status"], "solved");
    EXPECT_EQ(values["exit_code"], 0);
    const json& refined = values["refine"];
    EXPECT_EQ(refined["status"], "solved");
    ASSERT_EQ(refined["plan"]["steps"].size(), 2u);
    EXPECT_TRUE(refined["plan"]["steps"][0].get<std::string>().starts_with("(pick can p "));
    EXPECT_GT(refined["plan"]["duration"], 1);
    EXPECT_GT(refined["checked_configurations"], 100);
    EXPECT_GT(refined["phases"]["validate"], 0);
    EXPECT_GE(refined["statistics"]["stream_calls"], 4);
    const Outcome standard = carry({"--json", "-"});
    EXPECT_EQ(standard.exit_code, 0) << standard.err;
    EXPECT_EQ(json::parse(standard.out)["status"], "solved");
}

TEST_F(Refine, WritesTheMotion) {
    const std::string document = folder / "plan.json";
    const std::string csv = folder / "plan.csv";
    const std::string yaml = folder / "plan.yaml";
    const Outcome outcome =
        carry({"--trajectory", document, "--csv", csv, "--csv-rate", "10", "--yaml", yaml});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json values = json::parse(read_file(document));
    EXPECT_EQ(values["format"], "praxis-trajectory");
    ASSERT_EQ(values["plan"].size(), 2u);
    EXPECT_EQ(values["plan"][0]["name"], "pick");
    std::size_t attached = 0;
    for (const json& segment : values["segments"]) attached += segment.contains("attach") ? 1 : 0;
    EXPECT_EQ(attached, 1u);
    const double duration = values["plan"][1]["end"];

    const std::string rows = read_file(csv);
    EXPECT_TRUE(rows.starts_with("t,joint1,")) << rows.substr(0, 100);
    EXPECT_TRUE(contains(rows, "attach can")) << rows.substr(0, 1000);
    const auto lines = static_cast<double>(std::count(rows.begin(), rows.end(), '\n'));
    EXPECT_GT(lines, 10 * duration);
    EXPECT_LT(lines, 10 * duration + 40);
    EXPECT_TRUE(contains(read_file(yaml), "joint_names")) << read_file(yaml).substr(0, 500);
}

TEST_F(Refine, WritesOneThingToStandardOutput) {
    const Outcome document = carry({"--trajectory", "-"});
    EXPECT_EQ(document.exit_code, 0) << document.err;
    EXPECT_EQ(json::parse(document.out)["format"], "praxis-trajectory");
    const Outcome csv = carry({"--csv", "-"});
    EXPECT_TRUE(csv.out.starts_with("t,joint1,")) << csv.out.substr(0, 100);
    EXPECT_FALSE(contains(csv.out, "(pick can p #g1 #m1)  ;"));
    refused(carry({"--csv", "-", "--yaml", "-"}), "only one result can go to standard output");
    refused(carry({"--json", "-", "--trajectory", "-"}), "only one result can go to standard output");
}

TEST_F(Refine, WritesAPage) {
    const std::string page = folder / "plan.html";
    const Outcome outcome = carry({"--view", page});
    if (outcome.exit_code == 34) {
        EXPECT_TRUE(contains(outcome.err, "without the viewer")) << outcome.err;
        GTEST_SKIP() << "this build has no viewer";
    }
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string text = read_file(page);
    EXPECT_TRUE(contains(text, "<html"));
    EXPECT_TRUE(contains(text, "praxis-trajectory"));
}

TEST_F(Refine, FilesMayComeFromStandardInput) {
    EXPECT_EQ(refine({kDomain, "-", scene}, {.input = kProblem}).exit_code, 0);
    EXPECT_EQ(refine({kDomain, problem, "-"}, {.input = kScene}).exit_code, 0);
    EXPECT_EQ(carry({"--streams", "-"}, {.input = streams()}).exit_code, 0);
    refused(refine({kDomain, "-", "-"}), "only one file");
    refused(refine({"-", problem, scene}, {.input = read_file(kDomain)}), "--streams");
}

TEST_F(Refine, SeedsAndSpeed) {
    const auto duration = [&](const std::vector<std::string>& more) {
        const Outcome outcome = carry(more);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        const std::string mark = "; motion = ";
        return std::stod(outcome.out.substr(outcome.out.find(mark) + mark.size()));
    };
    const double whole = duration({});
    EXPECT_GT(duration({"--speed", "0.25"}), 1.5 * whole);
    EXPECT_GE(duration({"--by-home"}), whole);
    EXPECT_GT(duration({"--seed", "7"}), 0);
}

TEST_F(Refine, ListsTheFamilies) {
    const Outcome outcome = refine({"--list"});
    EXPECT_EQ(outcome.exit_code, 0);
    for (const char* family : {"blocked-shelf\n", "hanoi\n", "kitchen\n", "rooms\n", "infeasible twins"})
        EXPECT_TRUE(contains(outcome.out, family)) << family;
}

TEST_F(Refine, GeneratesProblems) {
    const Outcome made = refine({"--generate", "clutter", "--size", "3", "--seed", "5", folder / "made"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    EXPECT_TRUE(contains(made.out, "plan refine domains/tamp/pick-place/domain.pddl ")) << made.out;
    const Outcome solved = refine({kDomain, folder / "made/problem.pddl", folder / "made/scene.yaml"});
    EXPECT_EQ(solved.exit_code, 0) << solved.err;
    refine({"--generate", "clutter", "--size", "3", "--seed", "5", folder / "again"});
    EXPECT_EQ(read_file(folder / "made/scene.yaml"), read_file(folder / "again/scene.yaml"));
    refine({"--generate", "clutter", "--size", "3", "--seed", "6", folder / "again"});
    EXPECT_NE(read_file(folder / "made/scene.yaml"), read_file(folder / "again/scene.yaml"));

    refused(refine({"--generate", "clutter"}), "a folder is needed");
    refused(refine({"--generate", "clutters", folder / "x"}), "there is no family of problems 'clutters'");
    refused(refine({"--generate", "hanoi", "--size", "99", folder / "x"}), "hanoi");
    refused(refine({"--generate", "hanoi", "--infeasible", folder / "x"}), "has no infeasible problems");
    refused(refine({"--generate", "hanoi", "/proc/nowhere"}), "/proc/nowhere", 35);
    refused(refine({"--size", "3", kDomain, problem, scene}), "--generate");
}

TEST_F(Refine, InfeasibleIsSaidWithItsReasons) {
    const std::string far = with(kScene, "at: [-0.05, 0.25]", "at: [0.2, 0.45]");
    // Out of reach: two metres further.
    const std::string scene_file =
        folder.write("far.yaml", with(far, "pose: {xyz: [0.6, 0, 0.1]}", "pose: {xyz: [2.6, 0, 0.1]}"));
    const Outcome outcome = refine({kDomain, problem, scene_file, "--json", report, "--trajectory",
                                    folder / "tried.json", "--csv", folder / "none.csv"});
    EXPECT_EQ(outcome.exit_code, 11) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(contains(outcome.err, "infeasible at this discretisation, because\n  ")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "can")) << outcome.err;
    const json values = json::parse(read_file(report));
    EXPECT_EQ(values["status"], "infeasible");
    EXPECT_FALSE(values["refine"]["reasons"].empty());
    EXPECT_FALSE(values["refine"]["attempts"].empty());
    EXPECT_FALSE(json::parse(read_file(folder / "tried.json"))["attempts"].empty());
    EXPECT_FALSE(std::filesystem::exists(folder / "none.csv"));
}

TEST_F(Refine, NothingLeftToTryIsNoProof) {
    // The region is full, and has more places than are ever tried.
    std::string full = with(kScene, "surfaces:\n",
                            "  - {name: crate, box: [0.4, 0.3, 0.02], pose: {xyz: [0.6, -0.28, 0.165]}}\n"
                            "surfaces:\n");
    full += "stream_options: {placements: 100000}\n";
    const Outcome outcome =
        refine({kDomain, problem, folder.write("full.yaml", full), "--time-limit", "50", "--json", report});
    EXPECT_EQ(outcome.exit_code, 12) << outcome.err;
    EXPECT_TRUE(without_progress(outcome.err).starts_with("no plan was found\n")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "no free place for 'can' in 'right'")) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(json::parse(read_file(report))["status"], "failed");
}

TEST_F(Refine, WrongUsage) {
    refused(refine({}), "three files are needed");
    refused(refine({kDomain, problem}), "three files are needed");
    refused(carry({"more"}), "three files are needed");
    refused(carry({"--frobnicate"}), "--frobnicate");
    refused(carry({"--seed", "-1"}), "seed");
    refused(carry({"--speed", "2"}), "more than 1");
    refused(carry({"--speed", "0"}), "speed");
    refused(carry({"--speed", "nan"}), "speed");
    refused(carry({"--csv-rate", "0"}), "csv-rate");
    refused(carry({"--time-limit", "soon"}), "time-limit");
    refused(carry({"--search", "lazy("}), "lazy");
    refused(carry({"--search", "astar(no_such_heuristic())"}), "no_such_heuristic");
    const Outcome help = refine({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_TRUE(contains(help.out, "plan refine DOMAIN PROBLEM SCENE")) << help.out;
}

TEST_F(Refine, MissingFiles) {
    refused(refine({folder / "no.pddl", problem, scene}), "no.pddl");
    refused(refine({folder.write("domain.pddl", read_file(kDomain)), problem, scene}),
            folder / "streams.pddl");
    refused(refine({kDomain, folder / "no.pddl", scene}), "no.pddl");
    refused(refine({kDomain, problem, folder / "no.yaml"}), "no.yaml");
    refused(refine({kDomain, problem, folder / "."}), folder / ".");
    refused(carry({"--streams", folder / "no-streams.pddl"}), "no-streams.pddl");
}

TEST_F(Refine, BrokenScenes) {
    scene_refused("", "other.yaml");
    scene_refused("robot: [", "other.yaml:1:");
    scene_refused(std::string("\0\xff\x01", 3), "other.yaml");
    scene_refused(with(kScene, "regions:", "region:"), "did you mean 'regions'");
    scene_refused(with(kScene, "arm7", "arm8"), "arm8");
    scene_refused(with(kScene, "[0.6, 0, 0.1]", "[.nan, 0, 0.1]"), "other.yaml:3:");
    scene_refused(with(kScene, "[0.5, 1, 0.1]", "[0.5, -1, 0.1]"), "other.yaml:3:");
    scene_refused(with(kScene, "box: [0.5, 1, 0.1]", "mesh: missing.stl"), "missing.stl");
    scene_refused(std::string(kScene) + "stream_options: {aproach: 0.1}\n", "did you mean 'approach'");
    scene_refused(std::string(kScene) + "stream_options: {approach: near}\n", "'approach' must be a number");
}

TEST_F(Refine, BrokenRobots) {
    const auto robot = [&](const std::string& file) {
        return with(kScene, "{builtin: arm7, start: {arm: ready, gripper: open}}", "{urdf: " + file + "}");
    };
    scene_refused(robot("missing.urdf"), "missing.urdf");
    folder.write("broken.urdf", "<robot name='r'><link name='a'>");
    scene_refused(robot("broken.urdf"), "broken.urdf");
    folder.write("dangling.urdf",
                 "<robot name='r'><link name='a'/><joint name='j' type='fixed'><parent link='a'/><child "
                 "link='b'/></joint></robot>");
    scene_refused(robot("dangling.urdf"), "dangling.urdf");
    folder.write("mesh.urdf",
                 "<robot name='r'><link name='a'><collision><geometry><mesh "
                 "filename='no-such.stl'/></geometry></collision></link></robot>");
    scene_refused(robot("mesh.urdf"), "no-such.stl");
    folder.write("handless.urdf", "<robot name='r'><link name='a'/></robot>");
    scene_refused(robot("handless.urdf"), "end effector");
}

TEST_F(Refine, ScenesThatDoNotSuitTheTask) {
    scene_refused(with(kScene, "name: can, box", "name: tin, box"), "the scene has no body for 'can'");
    scene_refused(with(kScene, "name: right", "name: wrong"), "the scene has no region 'right'");
    scene_refused(with(kScene, "gripper: open", "gripper: closed"), "the fingers are not open at the start");
    scene_refused(with(kScene, "on: table, at: [-0.05, 0.25]", "pose: {xyz: [0.6, 0, 0.15]}"),
                  "the scene cannot start so");
    scene_refused(with(kScene, "pose: {xyz: [0.6, 0, 0.1]}", "pose: {xyz: [0.2, 0, 0.1]}"),
                  "the scene cannot start so");
}

TEST_F(Refine, BrokenTasks) {
    problem_refused(with(kProblem, "(at can p)", "(att can p)"), "other.pddl:3:");
    problem_refused(with(kProblem, "(at can p)", "(at can"), "other.pddl");
    streams_refused("", "other-streams.pddl");
    streams_refused(streams().substr(0, 300), "other-streams.pddl");
    streams_refused(with(streams(), "(graspable ?b)", "(grabable ?b)"), "did you mean 'graspable'");
    streams_refused(with(streams(), "(:stream plan-pick", "(:stream plan-pack"), "plan-pack");
}

TEST_F(Refine, UnsupportedLanguageIsNamed) {
    const std::string durative =
        "(:durative-action wait :parameters () :duration (= ?duration 1) :condition () "
        ":effect (at end (hand-empty)))\n  ";
    const std::string domain =
        folder.write("durative.pddl", with(with(read_file(kDomain), ":strips", ":strips :durative-actions"),
                                           "(:action pick", durative + "(:action pick"));
    refused(refine({domain, problem, scene, "--streams", folder.write("streams.pddl", streams())}),
            "durative actions are not supported", 34);
}

TEST_F(Refine, ResultsThatCannotBeWritten) {
    for (const char* option : {"--json", "--trajectory", "--csv", "--yaml"}) {
        const Outcome outcome = carry({option, "/dev/full"});
        EXPECT_EQ(outcome.exit_code, 35) << option << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "/dev/full")) << option << outcome.err;
        EXPECT_EQ(carry({option, folder / "no/such/folder/file"}).exit_code, 35) << option;
    }
    const Outcome pipe = carry({}, {.close_output = true});
    EXPECT_EQ(pipe.exit_code, 35);
    EXPECT_FALSE(pipe.killed);
}

TEST_F(LongRefine, InterruptEndsCleanly) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const Outcome outcome = carry({"--json", report}, {.signals = {{0.5, signal}}});
        EXPECT_EQ(outcome.exit_code, 128 + signal) << outcome.err;
        EXPECT_FALSE(outcome.killed);
        EXPECT_LT(outcome.seconds, 0.7 + kTolerance);
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(contains(outcome.err, "stopped by a signal")) << outcome.err;
        const json values = json::parse(read_file(report));
        EXPECT_EQ(values["status"], "interrupted");
        EXPECT_EQ(values["exit_code"], 128 + signal);
    }
}

TEST_F(LongRefine, TimeLimitHolds) {
    const Outcome outcome = carry({"--time-limit", "1", "--json", report});
    EXPECT_EQ(outcome.exit_code, 23) << outcome.err;
    EXPECT_GE(outcome.seconds, 0.9);
    EXPECT_LT(outcome.seconds, 1.2 + kTolerance);
    EXPECT_TRUE(contains(outcome.err, "the time limit is reached")) << outcome.err;
    EXPECT_EQ(json::parse(read_file(report))["status"], "out_of_time");
    for (const char* tiny : {"0.0001", "0.01", "0.1"}) {
        const Outcome soon = carry({"--time-limit", tiny});
        EXPECT_EQ(soon.exit_code, 23) << tiny << soon.err;
        EXPECT_LT(soon.seconds, std::stod(tiny) + 0.2 + kTolerance) << tiny;
    }
}

TEST_F(Refine, WithoutTheOtherProgramItIsNotBuilt) {
    const std::string alone = folder / "plan";
    std::filesystem::copy_file(PRAXIS_PLAN_COMMAND, alone);
    const Outcome outcome = run(alone, {"refine", kDomain, problem, scene});
    refused(outcome, "built without task and motion planning", 34);
    folder.write("plan-refine", "not a program");
    EXPECT_EQ(run(alone, {"refine", "--list"}).exit_code, 30);
}

}  // namespace
}  // namespace praxis::test
