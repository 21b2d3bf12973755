#include "practice/planning/cost_planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/practice/support/tokens.hpp"

namespace praxis::practice {
namespace {

using test::Tokens;

Tokens random_tokens() {
    const int tokens = *rc::gen::inRange(1, 4);
    const int places = *rc::gen::inRange(2, tokens == 3 ? 4 : 6);
    Tokens::Edges edges;
    for (int a = 0; a < places; ++a) {
        for (int b = 0; b < places; ++b) {
            const bool there = a == 0 && b == places - 1;
            if (a != b && (there || *rc::gen::inRange(0, 100) < 45)) edges.emplace_back(a, b);
        }
    }
    return {tokens, places, edges};
}

std::vector<Cost> random_costs(std::size_t count) {
    std::vector<Cost> costs;
    for (std::size_t i = 0; i < count; ++i) costs.push_back(success_cost(*rc::gen::inRange(1, 101) / 100.0));
    return costs;
}

/// Bellman-Ford over all states that are met, by executing the operators on values.
Cost naive_cost(const SkillTask& skills, const Situation& situation, std::span<const Cost> costs) {
    std::vector<std::vector<std::int32_t>> states = {situation.values};
    std::vector<Cost> best = {0};
    bool changed = true;
    while (changed) {
        changed = false;
        for (std::size_t i = 0; i < states.size(); ++i) {
            for (SkillIndex skill = 0; skill < skills.size(); ++skill) {
                if (!skills.applicable(skill, states[i])) continue;
                std::vector<std::int32_t> after = states[i];
                for (const GroundEffect& effect : skills.task().effects[skill])
                    after[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
                const Cost cost = best[i] + costs[skill];
                const auto place =
                    static_cast<std::size_t>(std::ranges::find(states, after) - states.begin());
                if (place == states.size()) {
                    states.push_back(after);
                    best.push_back(cost);
                    changed = true;
                } else if (cost < best[place]) {
                    best[place] = cost;
                    changed = true;
                }
            }
        }
    }
    Cost least = kNoPlan;
    for (std::size_t i = 0; i < states.size(); ++i) {
        if (all_hold(situation.goal, states[i].data())) least = std::min(least, best[i]);
    }
    return least;
}

Situation task_of(const Tokens& environment, const SkillTask& skills) {
    Random random(1);
    const PracticeTask task = environment.sample_task(random);
    Situation situation{{}, skills.goal(task.goal)};
    skills.read(task.initial, situation.values);
    return situation;
}

/// Some state on a random walk.
Situation somewhere(const SkillTask& skills, Situation situation) {
    for (int i = *rc::gen::inRange(0, 8); i > 0; --i) {
        std::vector<SkillIndex> applicable;
        skills.for_each_applicable(situation.values, [&](SkillIndex skill) { applicable.push_back(skill); });
        if (applicable.empty()) break;
        const SkillIndex skill = applicable[*rc::gen::inRange<std::size_t>(0, applicable.size())];
        for (const GroundEffect& effect : skills.task().effects[skill])
            situation.values[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    }
    return situation;
}

void check_plan(const SkillTask& skills, const Situation& situation, const SkillPlan& plan,
                std::span<const Cost> costs) {
    std::vector<std::int32_t> values = situation.values;
    Cost cost = 0;
    for (SkillIndex skill : plan.skills) {
        RC_ASSERT(skills.applicable(skill, values));
        for (const GroundEffect& effect : skills.task().effects[skill])
            values[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
        cost += costs[skill];
    }
    RC_ASSERT(all_hold(situation.goal, values.data()));
    RC_ASSERT(cost == plan.cost);
}

RC_GTEST_PROP(CostPlanner, plans_are_cheapest_however_they_were_found, ()) {
    const Tokens environment = random_tokens();
    const SkillTask skills(environment);
    CostPlanner planner(skills);
    const Situation first = task_of(environment, skills);
    for (int round = 0; round < 3; ++round) {
        const std::vector<Cost> costs = random_costs(skills.size());
        for (int repeat = 0; repeat < 3; ++repeat) {  // a way, then the table of distances
            const Situation situation = somewhere(skills, first);
            const std::optional<SkillPlan> plan = planner.plan(situation, costs);
            const Cost least = naive_cost(skills, situation, costs);
            RC_ASSERT(plan.has_value() == (least != kNoPlan));
            if (!plan) continue;
            RC_ASSERT(plan->cost == least);
            check_plan(skills, situation, *plan, costs);
        }
    }
}

RC_GTEST_PROP(CostPlanner, expected_costs_are_those_of_planning_anew, ()) {
    const Tokens environment = random_tokens();
    const SkillTask skills(environment);
    CostPlanner planner(skills, {.threads = 2});
    const Situation first = task_of(environment, skills);
    std::vector<Situation> situations = {first, first};
    for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
        situations.push_back(somewhere(skills, first));
        if (*rc::gen::arbitrary<bool>()) situations.back().goal.resize(1);
    }
    const std::vector<Cost> costs = random_costs(skills.size());
    const std::vector<Cost> others = random_costs(skills.size());
    std::vector<Improvement> improvements;
    for (SkillIndex skill = 0; skill < skills.size(); ++skill) improvements.push_back({skill, others[skill]});
    const std::vector<double> means = planner.expected_costs(situations, costs, improvements);
    for (const Improvement& improvement : improvements) {
        std::vector<Cost> changed = costs;
        changed[improvement.skill] = improvement.cost;
        double sum = 0, solvable = 0;
        for (const Situation& situation : situations) {
            const Cost cost = naive_cost(skills, situation, changed);
            if (cost == kNoPlan) continue;
            sum += nats(cost);
            solvable += 1;
        }
        const double mean = means[improvement.skill];
        if (solvable == 0) {
            RC_ASSERT(mean == std::numeric_limits<double>::infinity());
        } else {
            RC_ASSERT(std::abs(mean - sum / solvable) < 1e-9);
        }
    }
}

TEST(CostPlanner, PlansBySearchWhereThereAreTooManyStates) {
    const Tokens environment(3, 4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
    const SkillTask skills(environment);
    CostPlanner exact(skills);
    CostPlanner by_search(skills, {.most_states = 10});
    const Situation situation = task_of(environment, skills);
    std::vector<Cost> costs(skills.size(), success_cost(0.9));
    for (SkillIndex skill = 0; skill < skills.size(); ++skill) {
        if (skills.name(skill).find("p0 p3") != std::string::npos) costs[skill] = success_cost(0.1);
    }
    const auto plan = by_search.plan(situation, costs);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->cost, exact.plan(situation, costs)->cost);
    EXPECT_EQ(plan->skills.size(), 12u);
    const std::vector<Situation> situations = {situation};
    const std::vector<Improvement> improvements = {{skills.find("(move t0 p0 p3)"), success_cost(1)},
                                                   {skills.find("(mark t1 p3)"), success_cost(0.95)}};
    const auto means = by_search.expected_costs(situations, costs, improvements);
    const auto expected = exact.expected_costs(situations, costs, improvements);
    EXPECT_NEAR(means[0], expected[0], 1e-9);
    EXPECT_NEAR(means[1], expected[1], 1e-9);
}

TEST(CostPlanner, PrefersTheShorterOfEquallyLikelyPlans) {
    const Tokens environment(1, 4, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
    const SkillTask skills(environment);
    CostPlanner planner(skills);
    const std::vector<Cost> costs(skills.size(), success_cost(1));
    EXPECT_EQ(planner.plan(task_of(environment, skills), costs)->skills.size(), 2u);
}

/// Goals of tokens on certain places: token t0 on each place, with t1 on each, and so on.
std::vector<Situation> many_goals(const SkillTask& skills, Situation situation, int tokens, int places) {
    std::vector<Situation> result;
    std::vector<int> chosen(static_cast<std::size_t>(tokens), 0);
    for (bool more = true; more;) {
        std::vector<GroundAtom> atoms;
        for (int t = 0; t < tokens; ++t)
            atoms.push_back({0, {t, tokens + chosen[static_cast<std::size_t>(t)]}});
        situation.goal = skills.goal(atoms);
        result.push_back(situation);
        const auto next = std::ranges::find_if(chosen, [&](int place) { return place + 1 < places; });
        more = next != chosen.end();
        if (more) ++*next;
        std::fill(chosen.begin(), next, 0);
    }
    return result;
}

TEST(CostPlanner, ForgetsTheGoalsThatWereNotAskedAboutForLongest) {
    const Tokens environment(2, 17, [] {
        Tokens::Edges ring;
        for (int place = 0; place < 17; ++place) ring.emplace_back(place, (place + 1) % 17);
        return ring;
    }());
    const SkillTask skills(environment);
    CostPlanner planner(skills);
    const std::vector<Cost> costs(skills.size(), success_cost(0.5));
    const Situation marked = task_of(environment, skills);  // other variables matter
    const std::size_t marked_states = [&] {
        planner.plan(marked, costs);
        return planner.states();
    }();
    const std::vector<Situation> goals = many_goals(skills, marked, 2, 17);
    ASSERT_GT(goals.size(), CostPlanner::kMostGoals);
    std::vector<Cost> first;
    for (const Situation& situation : goals) {
        first.push_back(planner.plan(situation, costs)->cost);
        EXPECT_LE(planner.goals(), CostPlanner::kMostGoals + 1);
    }
    planner.plan(goals.back(), costs);
    EXPECT_EQ(planner.goals(), CostPlanner::kMostGoals);
    EXPECT_EQ(planner.states(), 17u * 17) << "those of the first goal are of no use any more";
    EXPECT_GT(marked_states, planner.states());
    for (std::size_t i = 0; i < goals.size(); ++i)
        EXPECT_EQ(planner.plan(goals[i], costs)->cost, first[i]) << "forgotten or not";
    EXPECT_EQ(planner.plan(marked, costs)->cost, CostPlanner(skills).plan(marked, costs)->cost);

    const std::vector<Improvement> improvements = {{0, success_cost(0.9)}};
    const double all = planner.expected_costs(goals, costs, improvements)[0];
    EXPECT_EQ(planner.goals(), 1 + goals.size()) << "one question may be about more";
    EXPECT_EQ(planner.expected_costs(goals, costs, improvements)[0], all);
    planner.plan(marked, costs);
    EXPECT_LE(planner.goals(), CostPlanner::kMostGoals + 1);
}

TEST(CostPlanner, RefusesWrongUse) {
    const Tokens environment(1, 2, {{0, 1}});
    const SkillTask skills(environment);
    EXPECT_THROW(CostPlanner(skills, {.search = "astar(nonsense())"}), std::invalid_argument);
    EXPECT_THROW(CostPlanner(skills, {.threads = 0}), std::invalid_argument);
    CostPlanner planner(skills);
    EXPECT_THROW(planner.plan(task_of(environment, skills), std::vector<Cost>(1)), std::invalid_argument);
}

TEST(SuccessCost, KeepsTheOrderOfCompetences) {
    EXPECT_EQ(success_cost(1), 1);
    EXPECT_EQ(success_cost(2), 1);
    EXPECT_EQ(success_cost(0), success_cost(kLeastCompetence));
    EXPECT_EQ(success_cost(std::numeric_limits<double>::quiet_NaN()), success_cost(kLeastCompetence));
    EXPECT_LT(success_cost(0.5 + 1e-11), success_cost(0.5));
    EXPECT_NEAR(nats(success_cost(0.25)), 2 * nats(success_cost(0.5)), 1e-11);
}

}  // namespace
}  // namespace praxis::practice
