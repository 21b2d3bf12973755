// All states of a task up to a bound, breadth first: by the textbook semantics of the lifted task, or of the
// ground task. Goals reached are remembered with their distance.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <queue>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tests/search/state/random_task.hpp"
#include "tests/search/support/naive_semantics.hpp"

namespace praxis::test {

/// How far the nearest goal is; if none was found, how far one was looked for.
struct Distance {
    std::optional<std::size_t> shortest;
    std::size_t looked_at = 0;  ///< every state at most this far was seen
    bool complete = false;      ///< all states were seen

    /// The two cannot both be true.
    bool contradicts(const Distance& other) const {
        if (shortest && other.shortest) return *shortest != *other.shortest;
        if (shortest) return other.complete || other.looked_at >= *shortest;
        if (other.shortest) return complete || looked_at >= *other.shortest;
        return false;
    }
};

struct LiftedSpace {
    struct Instance {
        const Schema* schema;
        NaiveSemantics::Tuple arguments;
        std::string name;
        Rational cost;
    };
    struct Edge {
        std::size_t instance;
        std::size_t target;
    };

    LiftedSpace(const LiftedTask& task, std::size_t most) : semantics(task) {
        for (const Schema& schema : task.schemas)
            semantics.instances(schema.scope, [&](const NaiveSemantics::Tuple& arguments) {
                const std::optional<Rational> cost = semantics.cost(schema, arguments);
                if (!cost) return;
                std::string name = schema.name;
                for (const std::uint32_t object : arguments) name += " " + task.objects[object].name;
                instances.push_back({&schema, arguments, std::move(name), *cost});
            });
        std::unordered_map<NaiveSemantics::State, std::size_t> numbers;
        std::vector<std::size_t> depth;
        const auto number = [&](NaiveSemantics::State state, std::size_t distance_to) {
            const auto [found, fresh] = numbers.try_emplace(state, states.size());
            if (fresh) {
                goal.push_back(semantics.goal(state));
                if (goal.back() && !distance.shortest) distance.shortest = distance_to;
                states.push_back(std::move(state));
                depth.push_back(distance_to);
            }
            return found->second;
        };
        number(semantics.initial(), 0);
        for (std::size_t i = 0; i < states.size() && i < most; ++i) {
            edges.emplace_back();
            for (std::size_t a = 0; a < instances.size(); ++a) {
                const auto& [schema, arguments, name, cost] = instances[a];
                if (!semantics.applicable(*schema, arguments, states[i])) continue;
                auto next = semantics.successor(*schema, arguments, states[i]);
                edges[i].push_back({a, number(std::move(next), depth[i] + 1)});
            }
        }
        distance.complete = edges.size() == states.size();
        distance.looked_at = depth[std::min(edges.size(), states.size() - 1)];
    }

    /// Of all states, which must be complete.
    std::optional<Rational> cheapest() const {
        std::vector<std::optional<Rational>> costs(states.size());
        costs[0] = Rational(0);
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t i = 0; i < edges.size(); ++i) {
                if (!costs[i]) continue;
                for (const Edge& edge : edges[i]) {
                    const Rational cost = *costs[i] + instances[edge.instance].cost;
                    if (costs[edge.target] && *costs[edge.target] <= cost) continue;
                    costs[edge.target] = cost;
                    changed = true;
                }
            }
        }
        std::optional<Rational> best;
        for (std::size_t i = 0; i < states.size(); ++i)
            if (goal[i] && costs[i] && (!best || *costs[i] < *best)) best = costs[i];
        return best;
    }

    NaiveSemantics semantics;
    std::vector<Instance> instances;  ///< those whose costs are defined
    std::vector<NaiveSemantics::State> states;
    std::vector<bool> goal;
    std::vector<std::vector<Edge>> edges;  ///< of the first states, the expanded ones
    Distance distance;
};

inline Distance ground_distance(const FiniteDomainTask& task, std::size_t most) {
    Distance distance;
    std::map<Values, std::size_t> numbers;
    std::vector<std::pair<Values, std::size_t>> states;
    const auto visit = [&](const Values& values, std::size_t depth) {
        if (!numbers.try_emplace(values, states.size()).second) return;
        states.emplace_back(values, depth);
        if (!distance.shortest && holds(task.goal, values)) distance.shortest = depth;
    };
    visit(initial_state(task), 0);
    std::size_t i = 0;
    for (; i < states.size() && i < most && !distance.shortest; ++i) {
        const auto [values, depth] = states[i];
        for (const OperatorId op : applicable(task, values)) visit(successor(task, values, op), depth + 1);
    }
    distance.complete = i == states.size();
    distance.looked_at = states[std::min(i, states.size() - 1)].second;
    return distance;
}

}  // namespace praxis::test
