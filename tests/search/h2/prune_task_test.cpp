// h2 against brute force on random tasks.
#include "search/h2/prune_task.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "search/h2/mutex_pairs.hpp"
#include "tests/search/evaluators/random_task.hpp"

namespace praxis::test {
namespace {

constexpr int kTasks = 10;  ///< for each case of a property
constexpr double kSeconds = 10;

/// `random_task` without conditions and derived variables: several of them are dropped or become ordinary.
FiniteDomainTask plain_task() {
    FiniteDomainTask task = random_task();
    task.axioms.clear();
    task.axiom_bodies = {};
    for (std::int32_t& layer : task.axiom_layers) layer = -1;
    PackedLists<GroundEffect> effects;
    for (std::size_t op = 0; op < task.operator_count(); ++op) {
        for (const GroundEffect& effect : task.effects[op]) effects.add({effect.fact, 0});
        effects.close();
    }
    task.effects = std::move(effects);
    task.conditions = {};
    task.conditions.close();
    return task;
}

FiniteDomainTask any_task() {
    return pick(2) == 0 ? plain_task() : random_task();
}

std::vector<std::pair<Fact, Fact>> pairs_of(const State& state) {
    std::vector<std::pair<Fact, Fact>> pairs;
    for (std::size_t v = 0; v < state.size(); ++v) {
        for (std::size_t w = 0; w <= v; ++w) {
            pairs.push_back(
                {{static_cast<std::int32_t>(v), state[v]}, {static_cast<std::int32_t>(w), state[w]}});
        }
    }
    return pairs;
}

/// Pairs of facts that no state reached contains, found by brute force, become groups; some of them.
void add_true_groups(FiniteDomainTask& task, const std::map<State, Estimate>& states) {
    std::set<std::pair<Fact, Fact>> together;
    for (const auto& [state, estimate] : states) {
        for (const auto& pair : pairs_of(state)) together.insert(pair);
    }
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(task.variable_count()); ++v) {
        for (std::int32_t w = 0; w < v; ++w) {
            const Fact a{v, pick(task.domain_sizes[static_cast<std::size_t>(v)])};
            const Fact b{w, pick(task.domain_sizes[static_cast<std::size_t>(w)])};
            if (!together.contains({a, b})) task.mutex_groups.append(std::vector<Fact>{b, a});
        }
    }
}

RC_GTEST_PROP(MutexPairs, NoReachableStateHasAForwardMutex, ()) {
    for (int round = 0; round < kTasks; ++round) {
        FiniteDomainTask task = any_task();
        const std::map<State, Estimate> states = perfect_estimates(task, task.costs);
        if (pick(3) == 0) add_true_groups(task, states);
        MutexPairs pairs(task);
        RC_ASSERT(pairs.forward({}));
        for (const auto& [state, estimate] : states) {
            for (const auto& [a, b] : pairs_of(state)) RC_ASSERT(!pairs.mutex(a, b));
            RC_ASSERT(!pairs.unsolvable() || estimate == kDeadEnd);
            for (std::size_t op = 0; op < task.operator_count(); ++op) {
                if (!holds(state, task.preconditions[op])) continue;
                RC_ASSERT(pairs.possible(OperatorId(op)));
                for (std::uint32_t i = 0; i < task.effects[op].size(); ++i) {
                    if (!holds(state, task.conditions[task.effects[op][i].condition])) continue;
                    RC_ASSERT(pairs.effect_possible(task.effects.begin_of(op) + i));
                }
            }
        }
    }
}

// The definition, one pair at a time: a pair {p, q} is reached by an operator that adds both, or adds p and
// leaves q, which was reached together with the precondition.
RC_GTEST_PROP(MutexPairs, ForwardIsH2OfTheTextbook, ()) {
    for (int round = 0; round < kTasks; ++round) {
        const FiniteDomainTask task = plain_task();
        const auto facts = static_cast<std::uint32_t>(task.fact_count());
        PairMatrix reached(facts);
        std::vector<Fact> by_number;
        for (std::int32_t v = 0; v < static_cast<std::int32_t>(task.variable_count()); ++v) {
            for (std::int32_t value = 0; value < task.domain_sizes[static_cast<std::size_t>(v)]; ++value) {
                by_number.push_back({v, value});
            }
        }
        for (const auto& [a, b] : pairs_of(task.initial_values)) {
            reached.set(task.fact_number(a), task.fact_number(b));
        }
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t op = 0; op < task.operator_count(); ++op) {
                std::map<std::int32_t, std::int32_t> after;
                for (const GroundEffect& effect : task.effects[op])
                    after[effect.fact.variable] = effect.fact.value;
                std::vector<std::uint32_t> needs;
                for (const Fact fact : task.preconditions[op]) needs.push_back(task.fact_number(fact));
                if (!reached.test_all(needs)) continue;
                for (std::uint32_t q = 0; q < facts; ++q) {
                    const Fact fact = by_number[q];
                    const auto set = after.find(fact.variable);
                    bool holds_after = set != after.end() && set->second == fact.value;
                    if (set == after.end()) {
                        std::vector<std::uint32_t> together = needs;
                        together.push_back(q);
                        holds_after = reached.test_all(together);
                    }
                    if (!holds_after) continue;
                    for (const auto& [variable, value] : after) {
                        const std::uint32_t p = task.fact_number({variable, value});
                        changed = changed || !reached.test(p, q);
                        reached.set(p, q);
                    }
                }
            }
        }
        MutexPairs pairs(task);
        RC_ASSERT(pairs.forward({}));
        for (std::uint32_t p = 0; p < facts; ++p) {
            for (std::uint32_t q = 0; q < facts; ++q) {
                RC_ASSERT(pairs.mutex(by_number[p], by_number[q]) == !reached.test(p, q));
            }
        }
    }
}

RC_GTEST_PROP(MutexPairs, NoStateOnAPlanHasABackwardMutex, ()) {
    for (int round = 0; round < kTasks; ++round) {
        FiniteDomainTask task = plain_task();
        const std::map<State, Estimate> states = perfect_estimates(task, task.costs);
        if (pick(3) == 0) add_true_groups(task, states);
        MutexPairs pairs(task);
        for (int turn = 0; turn < 3; ++turn) {
            RC_ASSERT(pairs.forward({}));
            RC_ASSERT(pairs.backward({}));
        }
        RC_ASSERT(!pairs.unsolvable() || states.at(task.initial_values) == kDeadEnd);
        if (pairs.unsolvable()) continue;
        for (const auto& [state, estimate] : states) {
            if (estimate == kDeadEnd) continue;
            for (const auto& [a, b] : pairs_of(state)) RC_ASSERT(!pairs.mutex(a, b));
        }
    }
}

RC_GTEST_PROP(PruneTask, EveryStepOfEveryPlanIsKept, ()) {
    for (int round = 0; round < kTasks; ++round) {
        FiniteDomainTask given = any_task();
        const std::map<State, Estimate> before = perfect_estimates(given, given.costs);
        if (pick(3) == 0) add_true_groups(given, before);
        const auto task = std::make_shared<const FiniteDomainTask>(std::move(given));
        const H2Result result = prune_with_h2(task, {}, kSeconds);
        RC_ASSERT(result.complete);
        const FiniteDomainTask& pruned = *result.task;
        RC_ASSERT(pruned.operator_count() == result.original.size());
        RC_ASSERT(pruned.operator_count() + result.removed_operators == task->operator_count());
        const State start = initial_state(*task);
        RC_ASSERT(initial_state(pruned) == start);
        if (pruned.proved_unsolvable) {
            RC_ASSERT(before.at(start) == kDeadEnd);
            continue;
        }
        const std::map<State, Estimate> after = perfect_estimates(pruned, pruned.costs);
        for (const auto& [state, estimate] : before) {
            if (estimate == kDeadEnd) continue;
            RC_ASSERT(after.contains(state));
            RC_ASSERT(after.at(state) == estimate);
        }
        std::set<OperatorId> kept(result.original.begin(), result.original.end());
        for (const auto& [state, estimate] : before) {
            for (std::size_t op = 0; op < task->operator_count(); ++op) {
                if (!holds(state, task->preconditions[op])) continue;
                const State next = successor(*task, state, op);
                RC_ASSERT(kept.contains(OperatorId(op)) || next == state || before.at(next) == kDeadEnd);
            }
        }
        for (const auto& [state, estimate] : after) {
            for (std::size_t op = 0; op < pruned.operator_count(); ++op) {
                if (!holds(state, pruned.preconditions[op])) continue;
                const std::size_t original = result.original[op].index();
                RC_ASSERT(holds(state, task->preconditions[original]));
                RC_ASSERT(pruned.costs[op] == task->costs[original]);
                RC_ASSERT(successor(pruned, state, op) == successor(*task, state, original));
            }
        }
    }
}

RC_GTEST_PROP(PruneTask, AnExhaustedBudgetChangesNothing, ()) {
    const auto task = std::make_shared<const FiniteDomainTask>(any_task());
    const H2Result result = prune_with_h2(task, {}, 0);
    RC_ASSERT(!result.complete);
    RC_ASSERT(result.task == task);
    RC_ASSERT(result.original.size() == task->operator_count());
}

/// Variable v of three values; a path 0 -> 1 and a trap 0 -> 2; w must be 1, which only 1 allows.
TEST(PruneTask, AWayIntoATrapIsRemoved) {
    FiniteDomainTask task;
    task.domain_sizes = {3, 2};
    task.axiom_layers = {-1, -1};
    task.initial_values = {0, 0};
    task.first_fact = {0, 3, 5};
    task.conditions.close();
    const auto add = [&](std::vector<Fact> precondition, Fact effect) {
        task.preconditions.append(precondition);
        task.effects.append(std::vector<GroundEffect>{{effect, 0}});
        task.costs.push_back(1);
    };
    add({{0, 0}}, {0, 1});
    add({{0, 0}, {1, 0}}, {0, 2});  // into the trap
    add({{0, 1}}, {1, 1});
    add({{0, 2}, {1, 1}}, {0, 0});  // never
    task.goal = {{1, 1}};
    const H2Result result = prune_with_h2(std::make_shared<const FiniteDomainTask>(task), {}, kSeconds);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.original, (std::vector{OperatorId(0), OperatorId(2)}));
    EXPECT_EQ(result.removed_operators, 2U);
    EXPECT_EQ(result.removed_facts, 1U);
    EXPECT_FALSE(result.task->proved_unsolvable);
}

/// Each of two goals can be met by the one resource, but not both.
TEST(PruneTask, ProvesThatTwoGoalsExcludeEachOther) {
    FiniteDomainTask task;
    task.domain_sizes = {2, 2, 2};
    task.axiom_layers = {-1, -1, -1};
    task.initial_values = {0, 0, 0};
    task.first_fact = {0, 2, 4, 6};
    task.conditions.close();
    for (std::int32_t v = 1; v <= 2; ++v) {
        task.preconditions.append(std::vector<Fact>{{0, 0}});
        task.effects.append(std::vector<GroundEffect>{{{0, 1}, 0}, {{v, 1}, 0}});
        task.costs.push_back(1);
    }
    task.goal = {{1, 1}, {2, 1}};
    const H2Result result = prune_with_h2(std::make_shared<const FiniteDomainTask>(task), {}, kSeconds);
    EXPECT_TRUE(result.task->proved_unsolvable);
}

}  // namespace
}  // namespace praxis::test
