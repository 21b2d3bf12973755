#include "practice/planning/state_graph.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "tests/practice/support/lamps.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::Lamps;
using test::Tokens;

using Values = std::vector<std::int32_t>;
using Edges = std::multiset<std::tuple<NodeIndex, SkillIndex, NodeIndex>>;

Values values_of(const SkillTask& skills, const State& state) {
    Values values;
    skills.read(state, values);
    return values;
}

Edges forward_edges(const StateGraph& graph) {
    Edges edges;
    for (NodeIndex node = 0; node < graph.size(); ++node) {
        for (const auto& edge : graph.forward(node)) edges.emplace(node, edge.skill, edge.node);
    }
    return edges;
}

Edges backward_edges(const StateGraph& graph) {
    Edges edges;
    for (NodeIndex node = 0; node < graph.size(); ++node) {
        for (const auto& edge : graph.backward(node)) edges.emplace(edge.node, edge.skill, node);
    }
    return edges;
}

TEST(StateGraph, KnowsConditionalEffectsAndDerivedPredicates) {
    const Lamps environment(3);
    const SkillTask skills(environment);
    StateGraph graph(skills, 1000);
    // By hand: the lights as bits, and sealed as 8.
    std::map<int, NodeIndex> nodes;
    for (int lights = 0; lights < 8; ++lights) {
        State state = environment.dark();
        for (std::size_t l = 0; l < 3; ++l) state[l] = lights >> l & 1;
        ASSERT_TRUE(graph.reach(values_of(skills, state), nodes[lights]));
    }
    ASSERT_TRUE(graph.reach(values_of(skills, {1, 1, 1, 1}), nodes[8]));
    EXPECT_EQ(graph.size(), 9u);
    Edges expected;
    for (int lights = 0; lights < 8; ++lights) {
        for (int l = 0; l < 3; ++l)
            expected.emplace(nodes[lights], skills.find("(toggle l" + std::to_string(l) + ")"),
                             nodes[lights ^ 1 << l]);
        const int shifted = (lights | lights << 1 | 1) & 7;
        if (shifted != lights) expected.emplace(nodes[lights], skills.find("(shift)"), nodes[shifted]);
    }
    expected.emplace(nodes[7], skills.find("(seal)"), nodes[8]);
    EXPECT_EQ(forward_edges(graph), expected);
    EXPECT_EQ(backward_edges(graph), expected);
}

TEST(StateGraph, FindsWhereFactsHold) {
    const Lamps environment(3);
    const SkillTask skills(environment);
    StateGraph graph(skills, 1000);
    NodeIndex lit = 0, sealed = 0, dark = 0;
    graph.reach(values_of(skills, environment.dark()), dark);
    graph.reach(values_of(skills, {1, 1, 1, 0}), lit);
    graph.reach(values_of(skills, {1, 1, 1, 1}), sealed);
    const auto where = [&](std::vector<GroundAtom> goal) {
        auto nodes = graph.where(skills.goal(goal));
        return std::set<NodeIndex>(nodes.begin(), nodes.end());
    };
    EXPECT_EQ(where({{2, {}}}), (std::set<NodeIndex>{lit, sealed}));
    EXPECT_EQ(where({{1, {}}}), (std::set<NodeIndex>{sealed}));
    EXPECT_EQ(where({{0, {0}}, {0, {1}}}).size(), 3u);
    EXPECT_EQ(where({}).size(), 9u);
}

RC_GTEST_PROP(StateGraph, is_what_executing_skills_says, ()) {
    const int places = *rc::gen::inRange(2, 5);
    Tokens::Edges ways = {{0, places - 1}};
    for (int a = 0; a < places; ++a) {
        for (int b = 0; b < places; ++b) {
            if (a != b && ways[0] != std::pair(a, b) && *rc::gen::inRange(0, 2) == 0) ways.emplace_back(a, b);
        }
    }
    const Tokens environment(*rc::gen::inRange(1, 3), places, ways);
    const SkillTask skills(environment);
    StateGraph graph(skills, 100'000);
    Random random(1);
    const State start = environment.sample_task(random).initial;
    std::vector<Values> states = {values_of(skills, start)};
    State elsewhere = start;  // perhaps met later, and not reachable from the start
    if (*rc::gen::arbitrary<bool>()) elsewhere[0] = places - 1;
    const Values other = values_of(skills, elsewhere);
    if (other != states[0]) states.push_back(other);
    Edges expected;
    for (std::size_t i = 0; i < states.size(); ++i) {
        NodeIndex node = 0;
        RC_ASSERT(graph.reach(states[i], node));
        for (SkillIndex skill = 0; skill < skills.size(); ++skill) {
            if (!skills.applicable(skill, states[i])) continue;
            Values after = states[i];
            for (const GroundEffect& effect : skills.task().effects[skill])
                after[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
            NodeIndex child = 0;
            RC_ASSERT(graph.reach(after, child));
            if (child != node) expected.emplace(node, skill, child);
            if (std::ranges::find(states, after) == states.end()) states.push_back(after);
        }
    }
    RC_ASSERT(graph.size() == states.size());
    RC_ASSERT(graph.edge_count() == expected.size());
    RC_ASSERT(forward_edges(graph) == expected);
    RC_ASSERT(backward_edges(graph) == expected);
}

TEST(StateGraph, SaysWhereItsLimitIs) {
    const Lamps environment(3);
    const SkillTask skills(environment);
    const Values dark = values_of(skills, environment.dark());
    NodeIndex node = 0;
    StateGraph enough(skills, 9);
    EXPECT_TRUE(enough.reach(dark, node));
    EXPECT_FALSE(enough.overflowed());
    for (const std::size_t most : {0u, 1u, 8u}) {
        StateGraph small(skills, most);
        EXPECT_FALSE(small.reach(dark, node)) << most;
        EXPECT_TRUE(small.overflowed());
        EXPECT_FALSE(small.reach(dark, node));
    }
}

}  // namespace
}  // namespace praxis::practice
