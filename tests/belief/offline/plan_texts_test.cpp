#include "belief/offline/plan_texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "belief/offline/optimal_policy.hpp"
#include "belief/offline/plan_blocks.hpp"
#include "belief/offline/plan_page.hpp"
#include "belief/offline/plan_tree.hpp"
#include "support.hpp"

namespace praxis::belief {
namespace {

class PlanTexts : public ::testing::Test {
  protected:
    std::shared_ptr<const BeliefTask> task_ = testing::ground(testing::corridor(2));
    OptimalPolicy policy_ = optimal_policy(task_);
};

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t result = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++result;
    return result;
}

/// Every tag is closed, in order; comments, scripts and the like do not occur.
void expect_well_formed(const std::string& page) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([a-zA-Z0-9]+)([^<>]*)>");
    const std::size_t start = page.find("<html");
    ASSERT_NE(start, std::string::npos);
    std::string between = page.substr(start);
    std::size_t tags = 0;
    for (std::sregex_iterator it(between.begin(), between.end(), tag), end; it != end; ++it, ++tags) {
        const std::string rest = (*it)[3];
        if ((*it)[1] == "/") {
            ASSERT_FALSE(open.empty());
            ASSERT_EQ(open.back(), (*it)[2]);
            open.pop_back();
        } else if (rest.empty() || rest.back() != '/') {
            open.push_back((*it)[2]);
        }
        ASSERT_EQ(std::count(rest.begin(), rest.end(), '"') % 2, 0) << rest;
    }
    EXPECT_TRUE(open.empty());
    EXPECT_EQ(tags, count(between, "<"));
    EXPECT_EQ(tags, count(between, ">"));
}

TEST_F(PlanTexts, JsonSaysWhatThePlanSays) {
    const auto json = nlohmann::json::parse(plan_to_json(*task_, policy_.plan));
    ASSERT_EQ(json["nodes"].size(), policy_.plan.size());
    EXPECT_EQ(json["action_nodes"], policy_.plan.action_nodes());
    EXPECT_EQ(json["depth"], policy_.plan.depth());
    std::size_t edges = 0, goals = 0, holds = 0, fails = 0;
    for (std::uint32_t node = 0; node < policy_.plan.size(); ++node) {
        const auto& entry = json["nodes"][node];
        EXPECT_EQ(entry["id"], node);
        goals += entry.contains("goal");
        if (entry.contains("goal")) continue;
        EXPECT_EQ(entry["action"], task_->physical->operator_name(OperatorId(policy_.plan.action(node))));
        for (const auto& edge : entry["edges"]) {
            ++edges;
            EXPECT_GT(edge["to"], node);
            for (const auto& report : edge["if"]) {
                EXPECT_EQ(report["atom"].get<std::string>().substr(0, 7), "(open c");
                (report["holds"].get<bool>() ? holds : fails) += 1;
            }
        }
    }
    EXPECT_EQ(goals, 1u);
    EXPECT_EQ(edges, policy_.plan.edge_count());
    EXPECT_EQ(json["edges"], edges);
    EXPECT_EQ(holds, fails);
    EXPECT_GT(holds, 2u);
}

TEST_F(PlanTexts, DotHasEveryNodeAndEdge) {
    const std::string dot = plan_to_dot(*task_, policy_.plan);
    EXPECT_EQ(dot.substr(0, 14), "digraph plan {");
    EXPECT_EQ(dot.substr(dot.size() - 2), "}\n");
    EXPECT_EQ(count(dot, " -> "), policy_.plan.edge_count());
    EXPECT_EQ(count(dot, "doublecircle"), 1u);
    EXPECT_EQ(count(dot, "\"") % 2, 0u);
    const std::regex statement("  (node|edge|n[0-9]+( -> n[0-9]+)?)( \\[[a-z]+=[^\\]]*\\])?;");
    std::istringstream lines(dot);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line != "}") EXPECT_TRUE(std::regex_match(line, statement)) << line;
}

TEST_F(PlanTexts, WhatIsReadAtFirstComesBeforeAllActions) {
    const auto task = testing::ground(testing::corridor(1, true));
    const OptimalPolicy policy = optimal_policy(task);
    EXPECT_EQ(plan_to_text(*task, policy.plan).find("1:\n    ; if "), 0u);
    EXPECT_NE(plan_to_dot(*task, policy.plan).find("n0 [label=\"start\"]"), std::string::npos);
    EXPECT_FALSE(nlohmann::json::parse(plan_to_json(*task, policy.plan))["nodes"][0].contains("action"));
    expect_well_formed(plan_to_html(*task, policy.plan, "start", ""));
}

TEST_F(PlanTexts, TheTextNamesEveryActionAndAnswer) {
    const std::string text = plan_to_text(*task_, policy_.plan);
    EXPECT_NE(text.find("    (look "), std::string::npos);
    EXPECT_NE(text.find("    ; if (open c"), std::string::npos);
    EXPECT_NE(text.find("    ; if not (open c"), std::string::npos);
    EXPECT_NE(text.find("    ; done"), std::string::npos);
    EXPECT_EQ(plan_to_text(*task_, PlanDraft().finish(0)), "; nothing to do\n");
}

TEST_F(PlanTexts, BlocksHaveEveryActionOnce) {
    const std::vector<PlanBlock> blocks = plan_blocks(*task_, policy_.plan);
    std::size_t actions = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        actions += blocks[i].actions.size();
        EXPECT_FALSE(blocks[i].choices.empty());
        for (const PlanBlock::Choice& choice : blocks[i].choices) EXPECT_GT(choice.target, i);
    }
    EXPECT_EQ(actions, policy_.plan.action_nodes());
}

TEST_F(PlanTexts, BoxesOfTheDrawingDoNotOverlap) {
    const std::vector<PlanBlock> blocks = plan_blocks(*task_, policy_.plan);
    const PlanTree tree = lay_out(blocks);
    std::set<std::uint32_t> drawn;
    for (const PlanBox& a : tree.boxes) {
        const bool block = a.kind == PlanBox::Kind::block;
        EXPECT_EQ(block && !drawn.insert(a.block).second, false);
        EXPECT_GE(a.x, 0);
        EXPECT_LE(a.x + a.width, tree.width);
        EXPECT_LE(a.y + a.height, tree.height);
        for (const PlanBox& b : tree.boxes)
            EXPECT_TRUE(&a == &b || a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y ||
                        b.y + b.height <= a.y);
    }
    EXPECT_EQ(drawn.size(), blocks.size());
}

TEST_F(PlanTexts, ThePageIsWellFormedAndLoadsNothing) {
    const std::string page = plan_to_html(*task_, policy_.plan, "a < b & \"c\"", "9 worlds");
    expect_well_formed(page);
    EXPECT_NE(page.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos);
    for (const char* loading : {"<script", "<link", "<img", "src=", "url(", "@import", "href=\"http"})
        EXPECT_EQ(page.find(loading), std::string::npos) << loading;
    // Every link leads somewhere.
    const std::regex link("href=\"#([bo][0-9]+)\"");
    std::size_t links = 0;
    for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it, ++links)
        EXPECT_NE(page.find(" id=\"" + (*it)[1].str() + "\""), std::string::npos);
    EXPECT_GT(links, 0u);
    expect_well_formed(plan_to_html(*task_, PlanDraft().finish(0), "empty", ""));
}

}  // namespace
}  // namespace praxis::belief
