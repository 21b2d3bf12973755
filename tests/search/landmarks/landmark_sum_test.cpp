// The landmark heuristic and the past landmarks it keeps, against their definitions.
#include "search/landmarks/landmark_sum.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "tests/search/evaluators/random_task.hpp"

namespace praxis {
namespace {

using test::State;
using Landmarks = std::set<std::size_t>;

/// Past landmarks by the letter: the child's from the parent's, predecessors looked up in the state before
/// (or, for landmarks of derived variables, in this one, until nothing changes).
Landmarks naive_step(const LandmarkGraph& graph, const Landmarks& before, const State& state) {
    Landmarks past = before;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
            const Landmarks& known = graph.derived[landmark] ? past : before;
            const bool ready = std::ranges::all_of(
                graph.predecessors[landmark],
                [&](const LandmarkGraph::Neighbour& other) { return known.contains(other.landmark); });
            if (ready && graph.holds(landmark, state) && past.insert(landmark).second) changed = true;
        }
    }
    return past;
}

Landmarks naive_start(const LandmarkGraph& graph, const State& state) {
    Landmarks past;
    for (std::size_t before = graph.size() + 1; past.size() != before;) {
        before = past.size();
        past = naive_step(graph, past, state);
    }
    return past;
}

Landmarks naive_required_again(const LandmarkGraph& graph, const Landmarks& past, const State& state) {
    Landmarks required;
    for (const std::size_t landmark : past) {
        bool needed = graph.goal[landmark];
        for (const LandmarkGraph::Neighbour next : graph.successors[landmark]) {
            needed = needed ||
                     (next.ordering == LandmarkOrdering::greedy_necessary && !past.contains(next.landmark));
        }
        needed = needed && !graph.holds(landmark, state);
        for (const std::uint32_t other : graph.undone_by[landmark]) needed = needed || !past.contains(other);
        if (needed) required.insert(landmark);
    }
    return required;
}

template <class Bits>
Landmarks as_set(const LandmarkGraph& graph, const Bits& bits) {
    Landmarks set;
    for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
        if (has_landmark(bits, landmark)) set.insert(landmark);
    }
    return set;
}

RC_GTEST_PROP(LandmarkSum, FollowsPathsByTheDefinition, ()) {
    const FiniteDomainTask task = test::random_task();
    const CostType cost_type = test::pick(2) == 0 ? CostType::one : CostType::normal;
    LandmarkSumEvaluator evaluator(task, task.goal, task.initial_values, cost_type);
    evaluator.request_preferred();
    const LandmarkGraph& graph = evaluator.graph();

    std::vector<State> states{test::initial_state(task)};
    std::vector<Landmarks> pasts{naive_start(graph, states[0])};
    // Numbers that fall into different blocks of the storage.
    const auto id = [](std::size_t number) { return StateId(number * 1777); };
    evaluator.start(id(0), states[0]);

    std::vector<LandmarkWord> bits(evaluator.status().words());
    const auto check = [&](std::size_t number) {
        const State& state = states[number];
        const Landmarks& past = pasts[number];
        evaluator.status().past(id(number), bits);
        RC_ASSERT(as_set(graph, bits) == past);
        evaluator.at(id(number));
        const Estimate estimate = evaluator.evaluate(state);
        const bool goal = test::holds(state, task.goal);
        RC_ASSERT(goal == (estimate == 0));
        const Landmarks required = naive_required_again(graph, past, state);
        if (!goal && cost_type == CostType::one) {
            const auto expected = static_cast<Estimate>(graph.size() - past.size() + required.size());
            RC_ASSERT(estimate == std::max(expected, 1));
        }
        Landmarks wanted;
        for (std::size_t landmark = 0; landmark < graph.size(); ++landmark) {
            if (past.contains(landmark) || graph.holds(landmark, state)) continue;
            const bool leaf = std::ranges::all_of(
                graph.predecessors[landmark],
                [&](const LandmarkGraph::Neighbour& other) { return past.contains(other.landmark); });
            if (leaf) wanted.insert(landmark);
        }
        if (past.size() == graph.size()) wanted = required;
        std::set<OperatorId> single, disjunctive;
        for (std::size_t op = 0; op < task.operator_count() && !goal; ++op) {
            if (!test::holds(state, task.preconditions[op])) continue;
            for (const GroundEffect& effect : task.effects[op]) {
                if (!test::holds(state, task.conditions[effect.condition])) continue;
                for (const std::size_t landmark : wanted) {
                    if (std::ranges::find(graph.facts[landmark], effect.fact) ==
                        graph.facts[landmark].end()) {
                        continue;
                    }
                    (graph.disjunctive(landmark) ? disjunctive : single).insert(OperatorId(op));
                }
            }
        }
        const auto preferred = evaluator.preferred();
        const std::set<OperatorId> found(preferred.begin(), preferred.end());
        RC_ASSERT(found.size() == preferred.size());
        RC_ASSERT(found == (single.empty() ? disjunctive : single));
    };

    check(0);
    for (int i = 0; i < 40; ++i) {
        const auto parent = static_cast<std::size_t>(test::pick(static_cast<std::int32_t>(states.size())));
        const auto op =
            static_cast<std::size_t>(test::pick(static_cast<std::int32_t>(task.operator_count())));
        if (!test::holds(states[parent], task.preconditions[op])) continue;
        const State next = test::successor(task, states[parent], op);
        const auto child = static_cast<std::size_t>(std::ranges::find(states, next) - states.begin());
        evaluator.follow(id(parent), OperatorId(op), id(child), next);
        if (child == parent) continue;
        const Landmarks past = naive_step(graph, pasts[parent], next);
        if (child == states.size()) {
            states.push_back(next);
            pasts.push_back(past);
        } else {
            std::erase_if(pasts[child], [&](std::size_t landmark) { return !past.contains(landmark); });
        }
        check(child);
    }
}

RC_GTEST_PROP(LandmarkSum, TakesAnyStateAsTheFirstOutsideOfASearch, ()) {
    const FiniteDomainTask task = test::random_task();
    LandmarkSumEvaluator alone(task, task.goal, task.initial_values, CostType::one);
    LandmarkSumEvaluator started(task, task.goal, task.initial_values, CostType::one);
    const State state = test::initial_state(task);
    started.start(StateId(0), state);
    started.at(StateId(0));
    RC_ASSERT(alone.evaluate(state) == started.evaluate(state));
}

TEST(LandmarkSum, OfACorridor) {
    // One variable moves 0, 1, ..., 99 up and down; all values are landmarks.
    constexpr std::int32_t kLength = 100;
    FiniteDomainTask task;
    task.domain_sizes = {kLength};
    task.axiom_layers = {-1};
    task.initial_values = {0};
    task.first_fact = {0, static_cast<std::uint32_t>(kLength)};
    task.conditions.close();
    for (std::int32_t i = 0; i + 1 < kLength; ++i) {
        for (const auto& [from, to] : {std::pair{i, i + 1}, std::pair{i + 1, i}}) {
            task.preconditions.append(std::vector<Fact>{{0, from}});
            task.effects.append(std::vector<GroundEffect>{{{0, to}, 0}});
            task.costs.push_back(1);
        }
    }
    task.goal = {{0, kLength - 1}};
    LandmarkSumEvaluator evaluator(task, task.goal, task.initial_values, CostType::one);
    evaluator.request_preferred();
    ASSERT_EQ(evaluator.graph().size(), static_cast<std::size_t>(kLength));
    evaluator.start(StateId(0), task.initial_values);
    for (std::int32_t i = 0; i + 1 < kLength; ++i) {
        const auto id = static_cast<std::size_t>(i);
        if (i > 0) evaluator.follow(StateId(id - 1), OperatorId(2 * id - 2), StateId(id), State{i});
        evaluator.at(StateId(id));
        EXPECT_EQ(evaluator.evaluate(State{i}), kLength - 1 - i);
        ASSERT_EQ(evaluator.preferred().size(), 1u);
        EXPECT_EQ(evaluator.preferred()[0], OperatorId(2 * id));
    }
    // A step back loses the value that the next step needs.
    evaluator.follow(StateId(50), OperatorId(99), StateId(1000), State{49});
    evaluator.at(StateId(1000));
    EXPECT_EQ(evaluator.evaluate(State{49}), kLength - 1 - 50 + 1);
}

}  // namespace
}  // namespace praxis
