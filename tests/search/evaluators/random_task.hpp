// Small random tasks with conditional effects and axioms, and what is true of them by brute force.
#pragma once

#include <rapidcheck.h>

#include <map>
#include <queue>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis::test {

using State = std::vector<std::int32_t>;

/// A number from 0 to n - 1.
inline std::int32_t pick(std::int32_t n) {
    return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, n));
}

/// A condition on up to `most` different variables out of the first `variables`, sorted.
inline std::vector<Fact> random_condition(const FiniteDomainTask& task, std::int32_t variables,
                                          std::int32_t most) {
    std::map<std::int32_t, std::int32_t> facts;
    for (std::int32_t left = pick(most + 1); left > 0; --left) {
        const std::int32_t variable = pick(variables);
        facts[variable] = pick(task.domain_sizes[static_cast<std::size_t>(variable)]);
    }
    std::vector<Fact> condition;
    for (const auto& [variable, value] : facts) condition.push_back({variable, value});
    return condition;
}

/// Up to five variables of two or three values, up to three derived ones, and up to eight operators. Derived
/// variables of the same layer may depend on each other.
inline FiniteDomainTask random_task() {
    FiniteDomainTask task;
    const std::int32_t plain = 2 + pick(4);
    const std::int32_t derived = pick(4);
    task.first_fact = {0};
    for (std::int32_t v = 0; v < plain + derived; ++v) {
        const bool is_derived = v >= plain;
        const std::int32_t size = is_derived ? 2 : 2 + pick(2);
        task.domain_sizes.push_back(size);
        task.axiom_layers.push_back(is_derived ? (v - plain) / 2 : -1);
        task.initial_values.push_back(pick(size));
        task.first_fact.push_back(task.first_fact.back() + static_cast<std::uint32_t>(size));
    }
    task.conditions.close();
    task.unit_cost = false;
    for (std::int32_t count = 1 + pick(8); count > 0; --count) {
        task.preconditions.append(random_condition(task, plain + derived, 3));
        for (std::int32_t effects = 1 + pick(4); effects > 0; --effects) {
            const std::int32_t variable = pick(plain);
            std::uint32_t condition = 0;
            if (pick(2) == 0) {
                condition = static_cast<std::uint32_t>(task.conditions.size());
                task.conditions.append(random_condition(task, plain + derived, 2));
            }
            task.effects.add(
                {{variable, pick(task.domain_sizes[static_cast<std::size_t>(variable)])}, condition});
        }
        task.effects.close();
        task.costs.push_back(pick(5));
    }
    for (std::int32_t v = plain; v < plain + derived; ++v) {
        for (std::int32_t count = pick(3); count > 0; --count) {
            std::vector<Fact> body = random_condition(task, plain + derived, 3);
            const auto layer = [&](std::int32_t variable) {
                return task.axiom_layers[static_cast<std::size_t>(variable)];
            };
            std::erase_if(body, [&](Fact fact) { return layer(fact.variable) > layer(v); });
            for (Fact& fact : body) {
                const std::int32_t fallback = task.initial_values[static_cast<std::size_t>(fact.variable)];
                if (layer(fact.variable) == layer(v)) fact.value = 1 - fallback;
            }
            task.axioms.push_back({{v, 1 - task.initial_values[static_cast<std::size_t>(v)]}});
            task.axiom_bodies.append(body);
        }
    }
    task.goal = random_condition(task, plain + derived, 3);
    return task;
}

inline bool holds(const State& state, std::span<const Fact> condition) {
    for (const Fact fact : condition) {
        if (state[static_cast<std::size_t>(fact.variable)] != fact.value) return false;
    }
    return true;
}

/// Sets the derived variables.
inline void derive(const FiniteDomainTask& task, State& state) {
    for (std::size_t v = 0; v < state.size(); ++v) {
        if (task.axiom_layers[v] >= 0) state[v] = task.initial_values[v];
    }
    for (std::int32_t layer = 0; layer < 2; ++layer) {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < task.axioms.size(); ++i) {
                const Fact head = task.axioms[i].head;
                const auto variable = static_cast<std::size_t>(head.variable);
                if (task.axiom_layers[variable] != layer || state[variable] == head.value) continue;
                if (!holds(state, task.axiom_bodies[i])) continue;
                state[variable] = head.value;
                changed = true;
            }
        }
    }
}

inline State initial_state(const FiniteDomainTask& task) {
    State state = task.initial_values;
    derive(task, state);
    return state;
}

inline State successor(const FiniteDomainTask& task, const State& state, std::size_t op) {
    State next = state;
    for (const GroundEffect& effect : task.effects[op]) {
        if (holds(state, task.conditions[effect.condition])) {
            next[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
        }
    }
    derive(task, next);
    return next;
}

/// The states that can be reached, each with the cost of an optimal plan from it (kDeadEnd: there is none).
inline std::map<State, Estimate> perfect_estimates(const FiniteDomainTask& task,
                                                   std::span<const std::int32_t> costs) {
    struct Edge {
        State from;
        std::int32_t cost;
    };
    std::map<State, std::vector<Edge>> incoming;
    std::map<State, Estimate> estimates;
    std::queue<State> open;
    const auto discover = [&](const State& state) {
        if (estimates.emplace(state, kDeadEnd).second) open.push(state);
    };
    discover(initial_state(task));
    while (!open.empty()) {
        const State state = open.front();
        open.pop();
        for (std::size_t op = 0; op < task.operator_count(); ++op) {
            if (!holds(state, task.preconditions[op])) continue;
            const State next = successor(task, state, op);
            incoming[next].push_back({state, costs[op]});
            discover(next);
        }
    }
    using Item = std::pair<Estimate, State>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    for (auto& [state, estimate] : estimates) {
        if (holds(state, task.goal)) queue.emplace(estimate = 0, state);
    }
    while (!queue.empty()) {
        const auto [cost, state] = queue.top();
        queue.pop();
        if (cost > estimates[state]) continue;
        for (const Edge& edge : incoming[state]) {
            Estimate& estimate = estimates[edge.from];
            if (cost + edge.cost >= estimate) continue;
            estimate = cost + edge.cost;
            queue.emplace(estimate, edge.from);
        }
    }
    return estimates;
}

}  // namespace praxis::test
