// Small random ground tasks, and what they mean, computed in the most literal way.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "search/task/finite_domain_task.hpp"

namespace praxis::test {

using Values = std::vector<std::int32_t>;

inline std::size_t at(std::int32_t index) {
    return static_cast<std::size_t>(index);
}

/// Tasks are built by hand: variables first, then operators and axioms, then `finish`.
inline void add_variable(FiniteDomainTask& task, std::int32_t domain_size, std::int32_t initial,
                         std::int32_t layer = -1) {
    task.domain_sizes.push_back(domain_size);
    task.initial_values.push_back(initial);
    task.axiom_layers.push_back(layer);
    if (task.first_fact.empty()) task.first_fact.push_back(0);
    task.first_fact.push_back(task.first_fact.back() + static_cast<std::uint32_t>(domain_size));
    if (task.conditions.size() == 0) task.conditions.close();
}

struct ConditionalEffect {
    Fact fact;
    std::vector<Fact> condition = {};
};

inline OperatorId add_operator(FiniteDomainTask& task, const std::vector<Fact>& precondition,
                               const std::vector<ConditionalEffect>& effects, std::int32_t cost = 1) {
    task.preconditions.append(precondition);
    for (const ConditionalEffect& effect : effects) {
        std::uint32_t condition = 0;
        if (!effect.condition.empty()) {
            condition = static_cast<std::uint32_t>(task.conditions.size());
            task.conditions.append(effect.condition);
        }
        task.effects.add({effect.fact, condition});
    }
    task.effects.close();
    task.costs.push_back(cost);
    if (cost != 1) task.unit_cost = false;
    return OperatorId(task.costs.size() - 1);
}

inline void add_axiom(FiniteDomainTask& task, Fact head, const std::vector<Fact>& body) {
    task.axioms.push_back({head});
    task.axiom_bodies.append(body);
}

struct RandomTaskOptions {
    int variables = 5;
    int largest_domain = 4;
    int derived = 0;
    int operators = 12;
    int largest_cost = 1;  ///< more than 1: costs from 0
    bool conditional_effects = false;
};

inline FiniteDomainTask random_task(std::uint64_t seed, const RandomTaskOptions& options) {
    std::mt19937_64 random(seed);
    const auto below = [&](int bound) { return static_cast<int>(random() % static_cast<unsigned>(bound)); };
    FiniteDomainTask task;
    // Derived variables lie among the others.
    int basic = options.variables, derived = options.derived;
    while (basic + derived > 0) {
        if (below(basic + derived) < basic) {
            const std::int32_t size = 1 + below(options.largest_domain);
            add_variable(task, size, below(size));
            --basic;
        } else {
            add_variable(task, 2, below(2), below(3));
            --derived;
        }
    }
    const auto variables = static_cast<int>(task.variable_count());
    // Sorted by variable, each at most once, `most` at most; `allowed` filters.
    const auto facts = [&](int most, const auto& allowed) {
        std::map<std::int32_t, std::int32_t> chosen;
        for (int i = below(most + 1); i > 0; --i) {
            const std::int32_t variable = below(variables);
            const Fact fact{variable, below(task.domain_sizes[at(variable)])};
            if (allowed(fact)) chosen[fact.variable] = fact.value;
        }
        std::vector<Fact> result;
        for (const auto& [variable, value] : chosen) result.push_back({variable, value});
        return result;
    };
    const auto anything = [](Fact) { return true; };
    for (std::int32_t head = 0; head < variables; ++head) {
        const std::int32_t layer = task.axiom_layers[at(head)];
        if (layer < 0) continue;
        for (int i = below(4); i > 0; --i) {
            add_axiom(task, {head, 1 - task.initial_values[at(head)]}, facts(3, [&](Fact fact) {
                          const std::int32_t other = task.axiom_layers[at(fact.variable)];
                          return other < layer ||
                                 (other == layer && fact.value != task.initial_values[at(fact.variable)]);
                      }));
        }
    }
    for (int i = 0; i < options.operators; ++i) {
        std::vector<ConditionalEffect> effects;
        for (int j = 1 + below(3); j > 0; --j) {
            const std::int32_t variable = below(variables);
            if (task.axiom_layers[at(variable)] >= 0) continue;
            effects.push_back({{variable, below(task.domain_sizes[at(variable)])}, {}});
            if (options.conditional_effects && below(2) == 0) effects.back().condition = facts(2, anything);
        }
        const std::int32_t cost = options.largest_cost > 1 ? below(options.largest_cost + 1) : 1;
        add_operator(task, facts(3, anything), effects, cost);
    }
    task.goal = facts(3, anything);
    return task;
}

inline bool holds(std::span<const Fact> condition, const Values& values) {
    for (const Fact& fact : condition) {
        if (values[at(fact.variable)] != fact.value) return false;
    }
    return true;
}

/// Sets the derived variables: each layer to its fixpoint, one after the other.
inline void derive(const FiniteDomainTask& task, Values& values) {
    std::int32_t last = -1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (task.axiom_layers[i] >= 0) values[i] = task.initial_values[i];
        last = std::max(last, task.axiom_layers[i]);
    }
    for (std::int32_t layer = 0; layer <= last; ++layer) {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < task.axioms.size(); ++i) {
                const Fact head = task.axioms[i].head;
                if (task.axiom_layers[at(head.variable)] != layer || values[at(head.variable)] == head.value)
                    continue;
                if (!holds(task.axiom_bodies[i], values)) continue;
                values[at(head.variable)] = head.value;
                changed = true;
            }
        }
    }
}

inline Values initial_state(const FiniteDomainTask& task) {
    Values values = task.initial_values;
    derive(task, values);
    return values;
}

inline std::vector<OperatorId> applicable(const FiniteDomainTask& task, const Values& values) {
    std::vector<OperatorId> result;
    for (std::size_t i = 0; i < task.operator_count(); ++i) {
        if (holds(task.preconditions[i], values)) result.push_back(OperatorId(i));
    }
    return result;
}

inline Values successor(const FiniteDomainTask& task, const Values& values, OperatorId op) {
    Values result = values;
    for (const GroundEffect& effect : task.effects[op.index()]) {
        if (holds(task.conditions[effect.condition], values))
            result[at(effect.fact.variable)] = effect.fact.value;
    }
    derive(task, result);
    return result;
}

/// Cost of the plan if it is one from the task's initial state to its goal, else -1.
inline std::int64_t execute(const FiniteDomainTask& task, std::span<const OperatorId> plan) {
    Values values = initial_state(task);
    std::int64_t cost = 0;
    for (OperatorId op : plan) {
        if (!holds(task.preconditions[op.index()], values)) return -1;
        values = successor(task, values, op);
        cost += task.costs[op.index()];
    }
    return holds(task.goal, values) ? cost : -1;
}

/// The cost of a cheapest plan, by brute force; -1: there is none.
inline std::int64_t cheapest_plan_cost(const FiniteDomainTask& task) {
    std::map<Values, std::int64_t> costs;
    using Entry = std::pair<std::int64_t, Values>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const Values initial = initial_state(task);
    costs[initial] = 0;
    queue.push({0, initial});
    while (!queue.empty()) {
        const auto [cost, values] = queue.top();
        queue.pop();
        if (cost > costs[values]) continue;
        if (holds(task.goal, values)) return cost;
        for (OperatorId op : applicable(task, values)) {
            const Values next = successor(task, values, op);
            const std::int64_t next_cost = cost + task.costs[op.index()];
            const auto [known, added] = costs.try_emplace(next, next_cost);
            if (!added && known->second <= next_cost) continue;
            known->second = next_cost;
            queue.push({next_cost, next});
        }
    }
    return -1;
}

/// `bits` switches that can be turned on and off, and a goal that no operator reaches: 2^bits states.
inline FiniteDomainTask endless_task(int bits) {
    FiniteDomainTask task;
    for (std::int32_t i = 0; i <= bits; ++i) add_variable(task, 2, 0);
    for (std::int32_t i = 0; i < bits; ++i) {
        add_operator(task, {{i, 0}}, {{{i, 1}, {}}});
        add_operator(task, {{i, 1}}, {{{i, 0}, {}}});
    }
    // Never applicable, so that only search can tell.
    add_operator(task, {{bits, 1}}, {{{bits, 1}, {}}});
    task.goal = {{bits, 1}};
    return task;
}

}  // namespace praxis::test
