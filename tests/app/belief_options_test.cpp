// `plan belief`: policies, beliefs, comparison with the best policy, conditional plans, pages.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/process.hpp"

namespace praxis::test {
namespace {

using Json = nlohmann::json;

std::string own_domain(const std::string& name) {
    return std::string(PRAXIS_SOURCE_DIR) + "/domains/belief/" + name + "/domain.pddl";
}
std::string own_problem(const std::string& name, const std::string& problem) {
    return std::string(PRAXIS_SOURCE_DIR) + "/problems/belief/" + name + "/" + problem + ".pddl";
}

/// Boxes, of which one or another holds the thing.
const std::string kDomain =
    "(define (domain boxes) (:requirements :typing :contingent) (:types box)\n"
    "  (:predicates (in ?b - box) (have))\n"
    "  (:action look :parameters (?b - box) :observe (in ?b))\n"
    "  (:action take :parameters (?b - box) :precondition (in ?b) :effect (have)))\n";
std::string boxes(const std::string& initial) {
    return "(define (problem three) (:domain boxes) (:objects b1 b2 b3 - box)\n  (:init " + initial +
           ")\n  (:goal (have)))\n";
}

class BeliefOptions : public testing::Test {
  protected:
    Outcome belief(std::vector<std::string> more) {
        std::vector<std::string> arguments{"belief", domain, problem};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return plan(arguments);
    }
    Json report() const { return Json::parse(read_file(json)); }
    Json runs() const { return report()["runs"]; }
    std::size_t successes(const std::vector<std::string>& more) {
        std::vector<std::string> all{"--json", json, "--quiet"};
        all.insert(all.end(), more.begin(), more.end());
        belief(all);
        const Json all_runs = runs();
        return static_cast<std::size_t>(std::count_if(
            all_runs.begin(), all_runs.end(), [](const Json& run) { return run["success"] == true; }));
    }

    TemporaryFolder folder;
    std::string domain = folder.write("domain.pddl", kDomain);
    std::string problem = folder.write("three.pddl", boxes("(oneof (in b1) (in b2) (in b3))"));
    std::string json = folder / "report.json";
};

TEST_F(BeliefOptions, EachPolicyActs) {
    for (const char* policy : {"plan", "random", "random-any", "sense-first"})
        EXPECT_EQ(successes({"--seeds", "20", "--policy", policy}), 20u) << policy;
    const Outcome outcome = belief({"--policy", "magic"});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "sense-first")) << outcome.err;
}

TEST_F(BeliefOptions, RefusedActionsCountInTheLength) {
    belief({"--seeds", "30", "--policy", "random-any", "--json", json});
    std::size_t actions = 0;
    double length = 0;
    for (const Json& run : runs()) {
        actions += run["actions"].get<std::size_t>();
        length += run["length"].get<double>();
    }
    EXPECT_GT(length, static_cast<double>(actions));
}

TEST_F(BeliefOptions, WeighingReadingsHelpsAgainstNoise) {
    const std::size_t exact =
        successes({"--seeds", "100", "--noise", "0.2", "--max-steps", "60", "--belief", "exact"});
    const std::size_t weighed = successes({"--seeds", "100", "--noise", "0.2", "--max-steps", "60"});
    const std::size_t sure =
        successes({"--seeds", "100", "--noise", "0.2", "--max-steps", "60", "--accept", "0.6"});
    EXPECT_GE(weighed, 90u);
    EXPECT_LT(exact, 80u);
    EXPECT_LT(sure, weighed);
}

TEST_F(BeliefOptions, StickyRunsGoOnAfterAContradiction) {
    // Who looks again and again reads the opposite at times.
    const auto contradictions = [&](const std::string& mode) {
        belief({"--seeds", "60", "--noise", "0.4", "--policy", "random", "--max-steps", "50", "--belief",
                mode, "--json", json, "--quiet"});
        std::size_t count = 0;
        for (const Json& run : runs()) count += run["status"] == "contradiction";
        return count;
    };
    EXPECT_GT(contradictions("exact"), 0u);
    EXPECT_EQ(contradictions("sticky"), 0u);
    EXPECT_EQ(contradictions("bayes"), 0u);
}

TEST_F(BeliefOptions, WorldsAreDrawnUniformly) {
    // Five first states, and none of them likelier; drawing one atom after the other would favour some.
    problem =
        folder.write("cut.pddl", boxes("(or (in b1) (in b2) (in b3)) (or (not (in b1)) (not (in b2)))"));
    const Outcome outcome = plan({"belief", domain, problem, "--seeds", "1000", "--policy", "random-any",
                                  "--max-steps", "400", "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::map<std::string, int> taken;
    for (const Json& run : runs()) ++taken[run["steps"].back()];
    // The states: {1}, {2}, {3}, {1, 3}, {2, 3}. A fair chooser takes b3 in 2 of 5 (1 + 1/2 + 1/2).
    EXPECT_NEAR(taken["(take b1)"], 300, 60);
    EXPECT_NEAR(taken["(take b2)"], 300, 60);
    EXPECT_NEAR(taken["(take b3)"], 400, 60);
}

TEST_F(BeliefOptions, TheBestPolicyIsTheYardstick) {
    // Look, look, take: 2, 3 and 3 actions; who knows the world takes at once.
    const Outcome outcome = belief({"--seeds", "60", "--optimum", "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(contains(outcome.out, "SPL (informed)")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "steps / best         1.000")) << outcome.out;
    std::map<std::string, double> costs;
    for (const Json& run : runs()) {
        EXPECT_EQ(run["omniscient_cost"], 1);
        EXPECT_EQ(run["length"], run["steps"].size());
        costs[run["steps"].back()] = run["policy_cost"];
    }
    ASSERT_EQ(costs.size(), 3u);
    EXPECT_EQ(costs["(take b1)"] + costs["(take b2)"] + costs["(take b3)"], 8);
    EXPECT_FALSE(contains(belief({"--seeds", "3", "--quiet"}).out, "SPL"));
    EXPECT_TRUE(contains(belief({"--optimum", "--quiet"}).out, "; of one who knows the world: 1\n"));
}

TEST_F(BeliefOptions, WhereThereIsNoBestPolicyTheReportSaysNothing) {
    // If the thing is nowhere nothing helps.
    problem = folder.write("loose.pddl", boxes("(unknown (in b1))"));
    const Outcome outcome = belief({"--seeds", "20", "--optimum", "--json", json});
    EXPECT_EQ(outcome.exit_code, 12);
    EXPECT_TRUE(contains(outcome.err, "no policy reaches the goal")) << outcome.err;
    std::size_t solvable = 0;
    for (const Json& run : runs()) {
        EXPECT_FALSE(run.contains("policy_cost"));
        EXPECT_EQ(run.contains("omniscient_cost"), run["success"] == true);
        solvable += run.contains("omniscient_cost");
    }
    EXPECT_GT(solvable, 0u);
    EXPECT_LT(solvable, 20u);
}

TEST_F(BeliefOptions, AConditionalPlan) {
    const std::string dot = folder / "plan.dot", html = folder / "plan.html";
    const Outcome outcome = belief({"--offline", "--dot", dot, "--html", html, "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(outcome.out.starts_with("1:\n    (look b")) << outcome.out;
    EXPECT_TRUE(contains(outcome.out, "executed in all 3 first states")) << outcome.out;
    EXPECT_TRUE(read_file(dot).starts_with("digraph")) << read_file(dot);
    EXPECT_TRUE(read_file(html).starts_with("<!DOCTYPE html>"));
    const Json offline = report()["offline"];
    EXPECT_EQ(offline["status"], "found");
    EXPECT_EQ(offline["depth"], 3);
    EXPECT_EQ(offline["all_worlds"], true);
    EXPECT_NEAR(offline["mean_cost"], 8.0 / 3, 1e-9);
    // From node 0, whatever is answered, the goal comes.
    const Json& nodes = offline["plan"]["nodes"];
    const std::function<int(std::size_t)> depth = [&](std::size_t node) {
        if (nodes[node].contains("goal")) return 0;
        int deepest = -1;
        for (const Json& edge : nodes[node]["edges"]) deepest = std::max(deepest, depth(edge["to"]));
        return deepest + 1;
    };
    EXPECT_EQ(depth(0), 3);
    EXPECT_TRUE(belief({"--offline", "--dot", "-", "--quiet"}).out.starts_with("digraph"));
}

TEST_F(BeliefOptions, ThereIsNoConditionalPlan) {
    problem = folder.write("loose.pddl", boxes("(unknown (in b1))"));
    const Outcome outcome = belief({"--offline", "--json", json});
    EXPECT_EQ(outcome.exit_code, 11) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "there is no conditional plan")) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(report()["status"], "unsolvable");
    EXPECT_EQ(report()["offline"]["status"], "unsolvable");
    EXPECT_FALSE(report()["offline"].contains("plan"));
}

TEST_F(BeliefOptions, NoConditionalPlanAgainstChance) {
    domain = folder.write("shaky.pddl",
                          "(define (domain boxes) (:requirements :typing :contingent) (:types box)\n"
                          "  (:predicates (in ?b - box) (have))\n"
                          "  (:action shake :parameters (?b - box) :effect (unknown (in ?b)))\n"
                          "  (:action look :parameters (?b - box) :observe (in ?b))\n"
                          "  (:action take :parameters (?b - box) :precondition (in ?b) :effect (have)))\n");
    const Outcome outcome = belief({"--offline"});
    EXPECT_EQ(outcome.exit_code, 34) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "chance")) << outcome.err;
}

TEST_F(BeliefOptions, ThePageShowsWhatWasKnownAtEachStep) {
    const std::string page = folder / "run.html", trace = folder / "trace.jsonl";
    problem = folder.write("a<b>&.pddl", boxes("(oneof (in b1) (in b2) (in b3))"));
    const Outcome outcome = belief({"--view", page, "--trace", trace, "--json", json, "--quiet"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string text = read_file(page);
    EXPECT_TRUE(contains(text, "a&lt;b&gt;&amp;.pddl</h1>"));
    EXPECT_FALSE(contains(text, "http"));  // nothing is loaded from elsewhere
    const std::string start = "<script type=\"application/json\" id=\"run\">";
    const std::size_t from = text.find(start) + start.size();
    const Json data = Json::parse(text.substr(from, text.find("</script>", from) - from));
    const Json run = report()["runs"][0];
    ASSERT_EQ(data["steps"].size(), run["steps"].size() + 1);
    for (std::size_t i = 0; i < run["steps"].size(); ++i)
        EXPECT_EQ(data["steps"][i + 1]["action"], run["steps"][i]);
    EXPECT_EQ(data["steps"].back()["end"], "reached");
    // Of the last plan made, the last action was the last of all.
    Json last_plan;
    for (const Json& step : data["steps"])
        for (const Json& made : step["plans"]) last_plan = made["actions"];
    ASSERT_FALSE(last_plan.empty());
    EXPECT_EQ(last_plan.back(), run["steps"].back());

    // Replayed, the page tells the same counts as the trace, for the atoms that are not certain from the
    // start.
    std::vector<int> values;
    std::vector<std::string> names;
    for (const Json& atom : data["atoms"]) {
        values.push_back(atom["first"]);
        names.push_back(atom["name"]);
    }
    std::map<std::size_t, std::size_t> unknown_after;  // by number of actions
    std::istringstream lines(read_file(trace));
    std::size_t actions = 0;
    for (std::string line; std::getline(lines, line);) {
        const Json event = Json::parse(line);
        actions += event["event"] == "executed";
        unknown_after[actions] = event["unknown"];
        EXPECT_EQ(event["known"].get<std::size_t>() + event["unknown"].get<std::size_t>(), 3u);
    }
    for (std::size_t i = 0; i < data["steps"].size(); ++i) {
        for (const Json& change : data["steps"][i]["changes"]) {
            EXPECT_NE(values[change[0]], change[1]);
            values[change[0]] = change[1];
        }
        EXPECT_EQ(static_cast<std::size_t>(std::count(values.begin(), values.end(), 0)), unknown_after[i])
            << "step " << i;
    }
    const std::string taken = run["steps"].back();  // "(take bN)"
    const auto atom = std::find(names.begin(), names.end(), "(in " + taken.substr(6));
    ASSERT_NE(atom, names.end());
    EXPECT_EQ(values[static_cast<std::size_t>(atom - names.begin())], 1);
}

TEST_F(BeliefOptions, APageIsOfOneRun) {
    const Outcome outcome = belief({"--seeds", "2", "--view", folder / "run.html"});
    EXPECT_EQ(outcome.exit_code, 31);
    EXPECT_TRUE(contains(outcome.err, "--seeds 1")) << outcome.err;
    EXPECT_EQ(belief({"--view", folder / "no/run.html"}).exit_code, 35);
}

TEST_F(BeliefOptions, WrongCombinations) {
    const std::map<std::string, std::vector<std::string>> cases = {
        {"--seeds", {"--offline", "--seeds", "3"}},
        {"--noise", {"--offline", "--noise", "0.1"}},
        {"--view", {"--offline", "--view", "x"}},
        {"--optimum", {"--offline", "--optimum"}},
        {"--belief", {"--offline", "--belief", "bayes"}},
        {"--dot", {"--dot", "x"}},
        {"--html", {"--html", "x"}},
        {"--accept", {"--belief", "sticky", "--accept", "0.9"}},
        {"0.5", {"--accept", "0.5"}},
        {"certain", {"--belief", "certain"}},
        {"--runs", {"--runs", "0"}},
        {"not a positive number", {"--plan-time", "nan"}},
        {"standard output", {"--json", "-", "--trace", "-"}},
    };
    for (const auto& [said, arguments] : cases) {
        const Outcome outcome = belief(arguments);
        EXPECT_EQ(outcome.exit_code, 31) << said;
        EXPECT_TRUE(contains(outcome.err, said)) << outcome.err;
        EXPECT_TRUE(contains(outcome.err, "plan belief --help")) << outcome.err;
    }
}

TEST(BeliefExamples, OfTheHelpPageWork) {
    const TemporaryFolder folder;
    const std::string doors = own_domain("doors"), walls = own_problem("doors", "two-walls");
    const std::string sort = own_domain("sort-weight"), two = own_problem("sort-weight", "two-boxes");
    EXPECT_EQ(plan({"belief", doors, walls, "--view", folder / "run.html"}).exit_code, 0);
    EXPECT_EQ(plan({"belief", doors, walls, "--offline", "--html", folder / "p.html"}).exit_code, 0);
    EXPECT_EQ(plan({"belief", sort, two, "--seeds", "50", "--optimum"}).exit_code, 0);
    const int noisy =
        plan({"belief", sort, two, "--seeds", "50", "--noise", "0.1", "--accept", "0.99"}).exit_code;
    EXPECT_TRUE(noisy == 0 || noisy == 12) << noisy;
}

}  // namespace
}  // namespace praxis::test
