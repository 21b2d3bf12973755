// Wrong usage and broken, hostile or unsupported input.
#include <gtest/gtest.h>

#include "tests/app/process.hpp"
#include "tests/app/tasks.hpp"

namespace praxis::test {
namespace {

class Input : public testing::Test {
  protected:
    /// Expects exit code 31 and a message with the part.
    void refused(const std::vector<std::string>& arguments, const std::string& part, int exit_code = 31) {
        const Outcome outcome = plan(arguments);
        EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
        EXPECT_LT(outcome.err.size(), 20000u);
    }

    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kWalkDomain);
    std::string problem = folder.write("walk1.pddl", kWalkProblem);
};

TEST_F(Input, WrongUsage) {
    refused({}, "plan --help");
    refused({domain, problem, "a", "b"}, "too many files");
    refused({domain, problem, "--frobnicate"}, "--frobnicate");
    refused({domain, problem, "--time-limit", "soon"}, "time-limit");
    refused({domain, problem, "--time-limit", "-1"}, "time-limit");
    refused({domain, problem, "--time-limit", "nan"}, "time-limit");
    refused({domain, problem, "--memory-limit", "0"}, "memory-limit");
    refused({domain, problem, "--threads", "0"}, "threads");
    refused({domain, problem, "--seed", "-1"}, "seed");
    refused({domain, problem, "--seed", "x"}, "seed");
    refused({domain, problem, "--alias", "no-such-alias"}, "no-such-alias");
    refused({domain, problem, "--search", "astar(no_such_heuristic())"}, "no_such_heuristic");
    refused({domain, problem, "--search", "astar(blind()"}, "astar");
    refused({domain, problem, "p1", "--plan-file", "p2"}, "two plan files");
    refused({"validate", domain, problem}, "plan validate");
    refused({"ground"}, "plan ground");
    refused({"list", "cakes"}, "cakes");
}

TEST_F(Input, PlanFileThatIsTheInput) {
    refused({domain, problem, problem}, "plan file");
    EXPECT_EQ(read_file(problem), kWalkProblem);
}

TEST_F(Input, MissingFilesAndFolders) {
    refused({domain, folder / "missing.pddl"}, "missing.pddl");
    refused({folder / "missing.pddl", problem}, "missing.pddl");
    refused({domain, folder / "."}, folder / ".");
    refused({domain, folder.write("empty.pddl", "")}, "empty.pddl");
    refused({"validate", domain, problem, folder / "missing.plan"}, "missing.plan");
}

TEST_F(Input, ErrorsNameThePlaceAndTheMend) {
    std::string text = kWalkProblem;
    text.replace(text.find("(at a)"), 6, "(att a)");
    const std::string file = folder.write("typo.pddl", text);
    const Outcome outcome = plan({domain, file});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "typo.pddl:2:")) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "did you mean 'at'")) << outcome.err;
}

TEST_F(Input, HostileFiles) {
    refused({domain, folder.write("deep.pddl", std::string(std::size_t{1} << 20, '('))}, "deep.pddl");
    refused({domain, folder.write("zeros.pddl", std::string(1000, '\0'))}, "zeros.pddl");
    refused({domain, folder.write("binary.pddl", std::string("\xff\xfe\x80(define\x01", 12))}, "binary.pddl");
    refused({domain, folder.write("cut.pddl", kWalkProblem.substr(0, 90))}, "cut.pddl");
    const std::string deep_goal =
        "(define (problem p) (:domain walk) (:objects a b c d - room) (:init (at a)) (:goal " +
        [] {
            std::string text;
            for (int i = 0; i < 100000; ++i) text += "(not ";
            return text;
        }() +
        "(at a)" + std::string(100000, ')') + "))";
    refused({domain, folder.write("nested.pddl", deep_goal)}, "nested.pddl");
}

TEST_F(Input, NotANumberIsNoCost) {
    const std::string costs =
        "(define (domain d) (:requirements :strips :action-costs) (:predicates (p)) (:functions (total-cost) "
        "(c))\n"
        "  (:action a :parameters () :precondition () :effect (and (p) (increase (total-cost) (c)))))\n";
    const std::string values =
        "(define (problem p) (:domain d) (:init (= (total-cost) 0) (= (c) nan)) (:goal (p))\n"
        "  (:metric minimize (total-cost)))\n";
    refused({folder.write("costs.pddl", costs), folder.write("nan.pddl", values)}, "nan.pddl:1:");
}

TEST_F(Input, UnsupportedLanguageIsNamed) {
    const std::string durative =
        "(define (domain d) (:requirements :durative-actions) (:predicates (p))\n"
        "  (:durative-action a :parameters () :duration (= ?duration 1) :condition () :effect (at end "
        "(p))))\n";
    const std::string task = "(define (problem p) (:domain d) (:init) (:goal (p)))\n";
    refused({folder.write("durative.pddl", durative), folder.write("p.pddl", task)}, "durative.pddl:2:", 34);
}

TEST_F(Input, WarningsGoToStandardErrorUnlessQuiet) {
    std::string text = kWalkDomain;
    text.replace(text.find(" :typing"), 8, "");
    const std::string file = folder.write("untyped.pddl", text);
    const Outcome outcome = plan({file, problem});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "warning: ")) << outcome.err;
    EXPECT_EQ(plan({file, problem, "--quiet"}).err, "");
}

}  // namespace
}  // namespace praxis::test
