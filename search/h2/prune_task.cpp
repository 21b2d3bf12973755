#include "search/h2/prune_task.hpp"

#include <span>
#include <utility>

#include "search/h2/mutex_pairs.hpp"

namespace praxis {

namespace {

constexpr std::size_t kMostBytes = std::size_t{128} << 20;  ///< for pairs; about 22,000 facts

H2Result unchanged(std::shared_ptr<const FiniteDomainTask> task) {
    H2Result result;
    for (std::uint32_t op = 0; op < task->operator_count(); ++op) result.original.emplace_back(op);
    result.task = std::move(task);
    return result;
}

/// Forward and backward in turn, until neither learns anything. `learnt`: at least one was finished.
bool analyze(MutexPairs& pairs, const Budget& budget, bool& learnt) {
    std::size_t count = 0;
    for (bool forward = true;; forward = !forward) {
        if (!(forward ? pairs.forward(budget) : pairs.backward(budget))) return false;
        const bool first = !learnt;
        learnt = true;
        if (pairs.unsolvable() || !pairs.can_go_backward()) return true;
        const std::size_t now = pairs.pair_count() + pairs.possible_count();
        if (!first && now == count) return true;
        count = now;
    }
}

/// The operators with an effect that may fire; of an operator without effects nothing is known, it stays.
std::vector<OperatorId> kept_operators(const FiniteDomainTask& task, const MutexPairs& pairs) {
    std::vector<OperatorId> kept;
    for (std::uint32_t op = 0; op < task.operator_count(); ++op) {
        if (!pairs.possible(OperatorId(op))) continue;
        bool fires = task.effects[op].empty();
        for (std::uint32_t i = 0; i < task.effects[op].size(); ++i) {
            fires = fires || pairs.effect_possible(task.effects.begin_of(op) + i);
        }
        if (fires) kept.emplace_back(op);
    }
    return kept;
}

FiniteDomainTask pruned(const FiniteDomainTask& task, const MutexPairs& pairs,
                        std::span<const OperatorId> kept) {
    FiniteDomainTask result;
    result.domain_sizes = task.domain_sizes;
    result.axiom_layers = task.axiom_layers;
    result.initial_values = task.initial_values;
    result.first_fact = task.first_fact;
    result.fact_names = task.fact_names;
    result.fact_forms = task.fact_forms;
    result.goal = task.goal;
    result.mutex_groups = task.mutex_groups;
    result.unit_cost = task.unit_cost;
    result.cost_scale = task.cost_scale;
    result.proved_unsolvable = task.proved_unsolvable || pairs.unsolvable();
    result.operator_names.symbols = task.operator_names.symbols;
    result.conditions.append(std::span<const Fact>());
    for (const OperatorId id : kept) {
        const std::size_t op = id.index();
        result.preconditions.append(task.preconditions[op]);
        for (std::uint32_t i = 0; i < task.effects[op].size(); ++i) {
            if (!pairs.effect_possible(task.effects.begin_of(op) + i)) continue;
            GroundEffect effect = task.effects[op][i];
            if (effect.condition != 0) {
                const std::span<const Fact> condition = task.conditions[effect.condition];
                effect.condition = static_cast<std::uint32_t>(result.conditions.size());
                result.conditions.append(condition);
            }
            result.effects.add(effect);
        }
        result.effects.close();
        result.costs.push_back(task.costs[op]);
        if (op < task.operator_names.size())
            result.operator_names.names.append(task.operator_names.names[op]);
    }
    for (std::size_t axiom = 0; axiom < task.axioms.size(); ++axiom) {
        if (!pairs.possible(task.axiom_bodies[axiom])) continue;
        result.axioms.push_back(task.axioms[axiom]);
        result.axiom_bodies.append(task.axiom_bodies[axiom]);
    }
    return result;
}

}  // namespace

H2Result prune_with_h2(std::shared_ptr<const FiniteDomainTask> task, const Budget& budget, double seconds) {
    H2Result result = unchanged(task);
    if (task->proved_unsolvable || MutexPairs::bytes(*task) > kMostBytes) return result;
    MutexPairs pairs(*task);
    bool learnt = false;
    result.complete = analyze(pairs, budget.within(seconds), learnt);
    if (!learnt) return result;
    for (std::size_t v = 0; v < task->variable_count(); ++v) {
        for (std::int32_t value = 0; value < task->domain_sizes[v]; ++value) {
            const Fact fact{static_cast<std::int32_t>(v), value};
            if (pairs.mutex(fact, fact)) ++result.removed_facts;
        }
    }
    std::vector<OperatorId> kept = kept_operators(*task, pairs);
    result.removed_operators = task->operator_count() - kept.size();
    result.task = std::make_shared<const FiniteDomainTask>(pruned(*task, pairs, kept));
    result.original = std::move(kept);
    return result;
}

}  // namespace praxis
