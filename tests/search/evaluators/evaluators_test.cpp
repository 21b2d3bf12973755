// Evaluators on tasks made by hand.
#include <gtest/gtest.h>

#include <array>

#include "search/evaluators/blind.hpp"
#include "search/evaluators/ff.hpp"
#include "search/evaluators/goal_count.hpp"
#include "search/evaluators/hadd.hpp"
#include "search/evaluators/hmax.hpp"
#include "search/evaluators/lmcut.hpp"
#include "search/evaluators/relaxed_task.hpp"

namespace praxis {
namespace {

struct OperatorSketch {
    std::vector<Fact> preconditions;
    std::vector<std::pair<std::vector<Fact>, Fact>> effects;  ///< condition, fact
    std::int32_t cost;
};

/// Binary variables, all 0; the goal is given.
FiniteDomainTask binary_task(std::size_t variables, const std::vector<OperatorSketch>& operators,
                             std::vector<Fact> goal) {
    FiniteDomainTask task;
    task.domain_sizes.assign(variables, 2);
    task.axiom_layers.assign(variables, -1);
    task.initial_values.assign(variables, 0);
    for (std::uint32_t i = 0; i <= variables; ++i) task.first_fact.push_back(2 * i);
    task.conditions.close();
    task.unit_cost = false;
    for (const OperatorSketch& sketch : operators) {
        task.preconditions.append(sketch.preconditions);
        for (const auto& [condition, fact] : sketch.effects) {
            std::uint32_t number = 0;
            if (!condition.empty()) {
                number = static_cast<std::uint32_t>(task.conditions.size());
                task.conditions.append(condition);
            }
            task.effects.add({fact, number});
        }
        task.effects.close();
        task.costs.push_back(sketch.cost);
    }
    task.goal = std::move(goal);
    return task;
}

template <class E>
Estimate estimate(const FiniteDomainTask& task, CostType cost_type = CostType::normal) {
    E evaluator(task, task.goal, cost_type);
    return evaluator.evaluate(task.initial_values);
}

// Two steps of cost 3 and 4 to goals 0 and 2; a third operator of cost 9 does both at once.
FiniteDomainTask two_goals() {
    return binary_task(
        3, {{{}, {{{}, {0, 1}}}, 3}, {{{0, 1}}, {{{}, {2, 1}}}, 4}, {{}, {{{}, {0, 1}}, {{}, {2, 1}}}, 9}},
        {{0, 1}, {2, 1}});
}

TEST(Evaluators, KnownValues) {
    const FiniteDomainTask task = two_goals();
    EXPECT_EQ(estimate<BlindEvaluator>(task), 3);
    EXPECT_EQ(estimate<GoalCountEvaluator>(task), 2);
    EXPECT_EQ(estimate<HmaxEvaluator>(task), 7);
    EXPECT_EQ(estimate<AddEvaluator>(task), 10);
    EXPECT_EQ(estimate<FFEvaluator>(task), 7);
    EXPECT_EQ(estimate<LMCutEvaluator>(task), 7);
}

TEST(Evaluators, CostTypes) {
    const FiniteDomainTask task = two_goals();
    EXPECT_EQ(estimate<BlindEvaluator>(task, CostType::one), 1);
    EXPECT_EQ(estimate<BlindEvaluator>(task, CostType::plus_one), 4);
    EXPECT_EQ(estimate<GoalCountEvaluator>(task, CostType::one), 2);
    EXPECT_EQ(estimate<HmaxEvaluator>(task, CostType::one), 1);
    EXPECT_EQ(estimate<LMCutEvaluator>(task, CostType::plus_one), 9);
    FiniteDomainTask unit = two_goals();
    unit.costs.assign(3, 1);
    EXPECT_EQ(estimate<BlindEvaluator>(unit, CostType::plus_one), 1);
}

TEST(Evaluators, AreZeroAtTheGoal) {
    FiniteDomainTask task = two_goals();
    task.initial_values = {1, 0, 1};
    EXPECT_EQ(estimate<BlindEvaluator>(task), 0);
    EXPECT_EQ(estimate<GoalCountEvaluator>(task), 0);
    EXPECT_EQ(estimate<HmaxEvaluator>(task), 0);
    EXPECT_EQ(estimate<AddEvaluator>(task), 0);
    EXPECT_EQ(estimate<FFEvaluator>(task), 0);
    EXPECT_EQ(estimate<LMCutEvaluator>(task), 0);
    task.goal.clear();
    EXPECT_EQ(estimate<HmaxEvaluator>(task), 0);
    EXPECT_EQ(estimate<FFEvaluator>(task), 0);
    EXPECT_EQ(estimate<LMCutEvaluator>(task), 0);
}

TEST(Evaluators, ProveDeadEnds) {
    FiniteDomainTask task = two_goals();
    task.goal.push_back({1, 1});
    task.goal = {{0, 1}, {1, 1}};
    EXPECT_EQ(estimate<HmaxEvaluator>(task), kDeadEnd);
    EXPECT_EQ(estimate<AddEvaluator>(task), kDeadEnd);
    EXPECT_EQ(estimate<FFEvaluator>(task), kDeadEnd);
    EXPECT_EQ(estimate<LMCutEvaluator>(task), kDeadEnd);
    EXPECT_EQ(estimate<BlindEvaluator>(task), 3);
}

TEST(Evaluators, LMCutCountsAnOperatorWithTwoConditionalEffectsOnce) {
    const FiniteDomainTask task =
        binary_task(4, {{{}, {{{{0, 0}}, {2, 1}}, {{{1, 0}}, {3, 1}}}, 5}}, {{2, 1}, {3, 1}});
    EXPECT_EQ(estimate<LMCutEvaluator>(task), 5);
    EXPECT_EQ(estimate<AddEvaluator>(task), 10);
    EXPECT_EQ(estimate<FFEvaluator>(task), 5);
}

TEST(Evaluators, AnOperatorWithSixHundredPreconditions) {
    constexpr std::int32_t kMany = 600;
    std::vector<OperatorSketch> operators(1);
    for (std::int32_t v = 0; v < kMany; ++v) {
        operators.push_back({{}, {{{}, {v, 1}}}, 1});
        operators[0].preconditions.push_back({v, 1});
    }
    operators[0].effects.push_back({{}, {kMany, 1}});
    operators[0].cost = 1;
    FiniteDomainTask task = binary_task(kMany + 1, operators, {{kMany, 1}});
    EXPECT_EQ(estimate<HmaxEvaluator>(task), 2);
    EXPECT_EQ(estimate<AddEvaluator>(task), kMany + 1);
    EXPECT_EQ(estimate<LMCutEvaluator>(task), kMany + 1);

    FFEvaluator ff(task, task.goal, CostType::normal);
    ff.request_preferred();
    EXPECT_EQ(ff.evaluate(task.initial_values), kMany + 1);
    EXPECT_EQ(ff.preferred().size(), static_cast<std::size_t>(kMany));
    std::vector<std::int32_t> almost(kMany + 1, 1);
    almost.back() = 0;
    EXPECT_EQ(ff.evaluate(almost), 1);
    ASSERT_EQ(ff.preferred().size(), 1u);
    EXPECT_EQ(ff.preferred()[0], OperatorId(0));
}

TEST(Evaluators, HugeCostsSaturateBelowDeadEnd) {
    std::vector<OperatorSketch> operators;
    for (std::int32_t v = 0; v < 9; ++v) {
        operators.push_back({{}, {{{}, {v, 1}}}, 2'000'000'000});
        if (v > 0) operators.back().preconditions.push_back({v - 1, 1});
    }
    const FiniteDomainTask task = binary_task(9, operators, {{3, 1}, {8, 1}});
    for (const Estimate value : {estimate<HmaxEvaluator>(task), estimate<AddEvaluator>(task),
                                 estimate<FFEvaluator>(task), estimate<LMCutEvaluator>(task)}) {
        EXPECT_GE(value, 1'000'000'000);
        EXPECT_LT(value, kDeadEnd);
    }
}

TEST(Evaluators, PreferOnlyOperatorsWhoseConditionalEffectIsNeededNow) {
    // Operator 0 helps only where variable 0 is set; operator 1 sets it.
    const FiniteDomainTask task =
        binary_task(2, {{{}, {{{{0, 1}}, {1, 1}}}, 1}, {{}, {{{}, {0, 1}}}, 1}}, {{1, 1}});
    FFEvaluator ff(task, task.goal, CostType::normal);
    EXPECT_EQ(ff.evaluate(task.initial_values), 2);
    EXPECT_TRUE(ff.preferred().empty());
    ff.request_preferred();
    ff.evaluate(task.initial_values);
    ASSERT_EQ(ff.preferred().size(), 1u);
    EXPECT_EQ(ff.preferred()[0], OperatorId(1));
    AddEvaluator hadd(task, task.goal, CostType::normal);
    hadd.request_preferred();
    EXPECT_EQ(hadd.evaluate(task.initial_values), 2);
    ASSERT_EQ(hadd.preferred().size(), 1u);
    EXPECT_EQ(hadd.preferred()[0], OperatorId(1));
}

TEST(Evaluators, DefaultValuesOfDerivedVariablesAreEarned) {
    // Derived variable 2 holds (value 1) while 0 or 1 is unset; the goal is that it does not hold.
    FiniteDomainTask task = binary_task(3, {{{}, {{{}, {0, 1}}}, 2}, {{}, {{{}, {1, 1}}}, 3}}, {{2, 0}});
    task.axiom_layers[2] = 0;
    for (std::int32_t v = 0; v < 2; ++v) {
        task.axioms.push_back({{2, 1}});
        task.axiom_bodies.append(std::vector<Fact>{{v, 0}});
    }
    const std::vector<std::int32_t> state{0, 0, 1};
    HmaxEvaluator hmax(task, task.goal, CostType::normal);
    EXPECT_EQ(hmax.evaluate(state), 3);
    LMCutEvaluator lmcut(task, task.goal, CostType::normal);
    EXPECT_EQ(lmcut.evaluate(state), 5);
}

TEST(Evaluators, DefaultValuesOfVariablesThatDependOnEachOtherAreFree) {
    // Derived variables 1 and 2 hold while 0 is unset, or while the other does; setting 0 ends both.
    FiniteDomainTask task = binary_task(3, {{{}, {{{}, {0, 1}}}, 2}}, {{1, 0}, {2, 0}});
    task.axiom_layers[1] = task.axiom_layers[2] = 0;
    for (std::int32_t v = 1; v < 3; ++v) {
        task.axioms.push_back({{v, 1}});
        task.axiom_bodies.append(std::vector<Fact>{{0, 0}});
        task.axioms.push_back({{v, 1}});
        task.axiom_bodies.append(std::vector<Fact>{{3 - v, 1}});
    }
    const std::vector<std::int32_t> state{0, 1, 1};
    HmaxEvaluator hmax(task, task.goal, CostType::normal);
    EXPECT_EQ(hmax.evaluate(state), 0);
    FFEvaluator ff(task, task.goal, CostType::normal);
    EXPECT_NE(ff.evaluate(state), kDeadEnd);
}

TEST(RelaxedTask, DropsWhatCannotMatterOrIsDominated) {
    using Dominance = RelaxedTask::Dominance;
    // Operator 0 reaches 1; operator 1 does so with a further precondition; operator 2 reaches what nobody
    // needs.
    const FiniteDomainTask task = binary_task(
        3, {{{}, {{{}, {1, 1}}}, 1}, {{{0, 0}}, {{{}, {1, 1}}}, 1}, {{}, {{{}, {2, 1}}}, 1}}, {{1, 1}});
    const RelaxedTask all(task, task.goal, CostType::normal, Dominance::keep);
    EXPECT_EQ(all.rule_count(), 3u);
    const RelaxedTask fewer(task, task.goal, CostType::normal, Dominance::drop);
    EXPECT_EQ(fewer.rule_count(), 2u);
    EXPECT_EQ(fewer.operator_of[0], 0u);
    EXPECT_EQ(fewer.fact_proposition[task.fact_number({2, 1})], RelaxedTask::kNone);
}

TEST(RelaxedTask, MergesRulesWithTheSamePreconditionsAndCost) {
    using Dominance = RelaxedTask::Dominance;
    // Operators 0 and 2 need the same and cost the same; operator 1 costs more.
    const FiniteDomainTask task = binary_task(5,
                                              {{{{0, 0}}, {{{}, {1, 1}}, {{}, {2, 1}}}, 1},
                                               {{{0, 0}}, {{{}, {3, 1}}}, 2},
                                               {{{0, 0}}, {{{}, {4, 1}}}, 1}},
                                              {{2, 1}, {3, 1}, {4, 1}, {1, 1}});
    const RelaxedTask all(task, task.goal, CostType::normal, Dominance::keep);
    EXPECT_EQ(all.rule_count(), 4u);
    const RelaxedTask fewer(task, task.goal, CostType::normal, Dominance::drop);
    ASSERT_EQ(fewer.rule_count(), 3u);
    EXPECT_EQ(fewer.rule(0).effects.size(), 3u);
    for (std::int32_t variable = 1; variable < 5; ++variable) {
        const std::uint32_t effect = fewer.fact_proposition[task.fact_number({variable, 1})];
        const std::uint32_t rule = variable == 3 ? 1 : 0;
        const std::array<std::uint32_t, 5> expected{0, 0, 0, 1, 2};
        EXPECT_EQ(fewer.operator_of[fewer.part(rule, effect)], expected[static_cast<std::size_t>(variable)]);
    }
    FFEvaluator ff(task, task.goal, CostType::normal);
    ff.request_preferred();
    EXPECT_EQ(ff.evaluate(task.initial_values), 4);
    EXPECT_EQ(ff.preferred().size(), 3u);
}

}  // namespace
}  // namespace praxis
