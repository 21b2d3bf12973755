#include "practice/planning/goal_bound.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "practice/planning/shortest_paths.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::Tokens;

struct TokenGraph {
    TokenGraph(int tokens, int places, const Tokens::Edges& edges)
        : environment(tokens, places, edges), skills(environment), graph(skills, 100'000) {
        Random random(1);
        const PracticeTask task = environment.sample_task(random);
        goal = skills.goal(task.goal);
        std::vector<std::int32_t> values;
        skills.read(task.initial, values);
        graph.reach(values, start);
    }
    std::vector<Cost> distances(std::span<const Cost> costs) const {
        std::vector<Cost> result;
        ShortestPaths(graph).to_goals(graph.where(goal), costs, result);
        return result;
    }
    Tokens environment;
    SkillTask skills;
    StateGraph graph;
    std::vector<Fact> goal;
    NodeIndex start = 0;
};

RC_GTEST_PROP(GoalBound, is_no_more_than_the_distance_and_falls_by_no_more_than_a_skill_costs, ()) {
    const int places = *rc::gen::inRange(2, 5);
    Tokens::Edges edges = {{0, places - 1}};
    for (int a = 1; a < places; ++a) {
        for (int b = 0; b < places; ++b) {
            if (a != b && *rc::gen::inRange(0, 2) == 0) edges.emplace_back(a, b);
        }
    }
    const TokenGraph tokens(*rc::gen::inRange(1, 4), places, edges);
    const auto costs =
        *rc::gen::container<std::vector<Cost>>(tokens.skills.size(), rc::gen::inRange<Cost>(1, 50));
    Projections projections(tokens.graph);
    const GoalBound bound(tokens.skills.task(), projections, tokens.goal, costs);
    const std::vector<Cost> distances = tokens.distances(costs);
    for (NodeIndex node = 0; node < tokens.graph.size(); ++node) {
        RC_ASSERT(bound(node) <= distances[node]);
        if (bound(node) == kNoPlan) continue;
        for (const StateGraph::Edge& edge : tokens.graph.forward(node))
            RC_ASSERT(bound(node) - costs[edge.skill] <= bound(edge.node));
    }
}

TEST(GoalBound, IsExactForOneTokenAlone) {
    TokenGraph tokens(2, 3, {{0, 1}, {1, 2}, {2, 0}});
    tokens.goal.resize(1);
    std::vector<Cost> costs;
    for (std::size_t i = 0; i < tokens.skills.size(); ++i) costs.push_back(static_cast<Cost>(3 + i));
    Projections projections(tokens.graph);
    const GoalBound bound(tokens.skills.task(), projections, tokens.goal, costs);
    const std::vector<Cost> distances = tokens.distances(costs);
    EXPECT_GT(distances[tokens.start], 0);
    for (NodeIndex node = 0; node < tokens.graph.size(); ++node) EXPECT_EQ(bound(node), distances[node]);
    EXPECT_EQ(GoalBound()(tokens.start), 0);
}

}  // namespace
}  // namespace praxis::practice
