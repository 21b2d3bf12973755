#include "practice/planning/improved_paths.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "practice/planning/shortest_paths.hpp"
#include "tests/practice/support/lamps.hpp"

namespace praxis::practice {
namespace {

using test::Lamps;

/// Lamps, of which any may be the beginning and all lit the goal.
struct LampGraph {
    explicit LampGraph(int lamps) : environment(lamps), skills(environment), graph(skills, 100'000) {
        std::vector<std::int32_t> values;
        skills.read(environment.dark(), values);
        graph.reach(values, dark);
        goals = graph.where(skills.goal(std::vector<GroundAtom>{{2, {}}}));
    }
    Cost cheapest(NodeIndex from, const std::vector<Cost>& costs, std::vector<SkillIndex>& plan) {
        ShortestPaths paths(graph);
        Cost cost = kNoPlan;
        paths.way(from, goals, costs, plan, cost);
        return cost;
    }
    GoalBound bound(const std::vector<Cost>& costs) {
        return {skills.task(), projections, skills.goal(std::vector<GroundAtom>{{2, {}}}), costs};
    }
    Lamps environment;
    SkillTask skills;
    StateGraph graph;
    Projections projections{graph};
    NodeIndex dark = 0;
    std::vector<NodeIndex> goals;
};

std::vector<Cost> random_costs(std::size_t count) {
    return *rc::gen::container<std::vector<Cost>>(count, rc::gen::inRange<Cost>(1, 60));
}

RC_GTEST_PROP(ShortestPaths, ways_are_as_long_as_the_distances_say, ()) {
    LampGraph lamps(*rc::gen::inRange(1, 5));
    const auto costs = random_costs(lamps.skills.size());
    ShortestPaths paths(lamps.graph);
    std::vector<Cost> distances;
    paths.to_goals(lamps.goals, costs, distances);
    for (NodeIndex node = 0; node < lamps.graph.size(); ++node) {
        std::vector<SkillIndex> plan;
        RC_ASSERT(lamps.cheapest(node, costs, plan) == distances[node]);
        Cost sum = 0;
        for (const SkillIndex skill : plan) sum += costs[skill];
        RC_ASSERT(sum == distances[node]);
    }
}

RC_GTEST_PROP(ImprovedPaths, agree_with_planning_anew, ()) {
    LampGraph lamps(*rc::gen::inRange(1, 6));
    ImprovedPaths improved(lamps.graph);  // one for all questions
    for (int round = 0; round < 3; ++round) {
        const auto costs = random_costs(lamps.skills.size());
        std::vector<Improvement> improvements;
        std::vector<Cost> least = costs;
        for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
            const auto skill = *rc::gen::inRange<SkillIndex>(0, static_cast<SkillIndex>(costs.size()));
            improvements.push_back({skill, *rc::gen::inRange<Cost>(1, costs[skill] + 1)});
            least[skill] = std::min(least[skill], improvements.back().cost);
        }
        const auto from = *rc::gen::inRange<NodeIndex>(0, static_cast<NodeIndex>(lamps.graph.size()));
        std::vector<SkillIndex> plan;
        const Cost now = lamps.cheapest(from, costs, plan);
        if (now == kNoPlan) continue;
        improved.begin(from, lamps.goals, costs, least, lamps.bound(least), plan, now);
        for (const Improvement& improvement : improvements) {
            std::vector<Cost> changed = costs;
            changed[improvement.skill] = improvement.cost;
            std::vector<SkillIndex> other;
            RC_ASSERT(improved.cost(improvement) == lamps.cheapest(from, changed, other));
        }
    }
}

TEST(ImprovedPaths, CountASkillAsOftenAsThePlanUsesIt) {
    LampGraph lamps(4);
    std::vector<Cost> costs(lamps.skills.size(), 30);
    const SkillIndex shift = lamps.skills.find("(shift)"), toggle = lamps.skills.find("(toggle l0)");
    costs[shift] = 9;
    std::vector<SkillIndex> plan;
    const Cost now = lamps.cheapest(lamps.dark, costs, plan);
    ASSERT_EQ(now, 36);
    ImprovedPaths improved(lamps.graph);
    std::vector<Cost> least = costs;
    least[shift] = 2;
    least[toggle] = 1;
    improved.begin(lamps.dark, lamps.goals, costs, least, lamps.bound(least), plan, now);
    EXPECT_EQ(improved.cost({shift, 2}), 8);
    EXPECT_EQ(improved.cost({shift, 9}), 36);
    EXPECT_EQ(improved.cost({toggle, 1}), 28);  // once, then three shifts
    EXPECT_EQ(improved.cost({toggle, 30}), 36);
}

TEST(ImprovedPaths, WhereTheGoalHoldsNothingCostsAnything) {
    LampGraph lamps(2);
    const std::vector<Cost> costs(lamps.skills.size(), 10), least(lamps.skills.size(), 1);
    ImprovedPaths improved(lamps.graph);
    improved.begin(lamps.goals[0], lamps.goals, costs, least, lamps.bound(least), {}, 0);
    for (SkillIndex skill = 0; skill < lamps.skills.size(); ++skill) EXPECT_EQ(improved.cost({skill, 1}), 0);
}

}  // namespace
}  // namespace praxis::practice
