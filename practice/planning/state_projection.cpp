#include "practice/planning/state_projection.hpp"

#include <algorithm>
#include <numeric>

namespace praxis::practice {

namespace {

/// The variable, then those in the preconditions of the skills that change it.
std::vector<std::int32_t> dependent(const FiniteDomainTask& task, std::int32_t variable) {
    std::vector<std::int32_t> uses(task.variable_count(), 0);
    for (std::size_t skill = 0; skill < task.operator_count(); ++skill) {
        const auto changes = [&](const GroundEffect& effect) { return effect.fact.variable == variable; };
        if (!std::ranges::any_of(task.effects[skill], changes)) continue;
        for (const Fact& fact : task.preconditions[skill]) ++uses[static_cast<std::size_t>(fact.variable)];
    }
    std::vector<std::int32_t> others;
    for (std::int32_t other = 0; static_cast<std::size_t>(other) < uses.size(); ++other) {
        if (other != variable && uses[static_cast<std::size_t>(other)] > 0 && !task.derived(other))
            others.push_back(other);
    }
    std::ranges::stable_sort(others, [&](std::int32_t a, std::int32_t b) {
        return uses[static_cast<std::size_t>(a)] > uses[static_cast<std::size_t>(b)];
    });
    std::vector<std::int32_t> result = {variable};
    auto states = static_cast<std::size_t>(task.domain_sizes[static_cast<std::size_t>(variable)]);
    for (const std::int32_t other : others) {
        const auto domain = static_cast<std::size_t>(task.domain_sizes[static_cast<std::size_t>(other)]);
        if (states * domain > StateProjection::kMostStates) continue;
        states *= domain;
        result.push_back(other);
    }
    return result;
}

}  // namespace

StateProjection::StateProjection(const StateGraph& graph, std::int32_t variable)
    : domain_(static_cast<std::size_t>(graph.task().domain_sizes[static_cast<std::size_t>(variable)])) {
    project(graph, dependent(graph.task(), variable));
    collect_edges(graph);
}

void StateProjection::project(const StateGraph& graph, std::span<const std::int32_t> variables) {
    states_.assign(graph.size(), 0);
    for (const std::int32_t variable : variables) {
        for (NodeIndex node = 0; node < graph.size(); ++node)
            states_[node] +=
                static_cast<std::uint32_t>(size_) * static_cast<std::uint32_t>(graph.value(node, variable));
        size_ *= static_cast<std::size_t>(graph.task().domain_sizes[static_cast<std::size_t>(variable)]);
    }
}

void StateProjection::collect_edges(const StateGraph& graph) {
    std::vector<Edge> found;
    std::vector<SkillIndex> last(size_ * size_, static_cast<SkillIndex>(-1));  // that was found for a pair
    first_edge_.assign(size_ + 1, 0);
    for (SkillIndex skill = 0; skill < graph.task().operator_count(); ++skill) {
        for (const StateGraph::Arc& arc : graph.arcs(skill)) {
            const Edge edge{states_[arc.from], states_[arc.to], skill};
            SkillIndex& known = last[edge.from * size_ + edge.to];
            if (edge.from == edge.to || known == skill) continue;
            known = skill;
            found.push_back(edge);
            ++first_edge_[edge.to + 1];
        }
    }
    std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
    std::vector<std::size_t> next(first_edge_.begin(), first_edge_.end() - 1);
    edges_.resize(found.size());
    for (const Edge& edge : found) edges_[next[edge.to]++] = edge;
}

std::vector<Cost> StateProjection::distances(Fact goal, std::span<const Cost> costs) const {
    std::vector<Cost> result(size_, kNoPlan);
    NodeQueue queue;
    for (std::size_t state = static_cast<std::size_t>(goal.value); state < size_; state += domain_) {
        result[state] = 0;
        queue.push(0, static_cast<NodeIndex>(state));
    }
    while (!queue.empty()) {
        const auto [cost, state] = queue.pop();
        if (cost > result[state]) continue;
        for (std::size_t i = first_edge_[state]; i < first_edge_[state + 1]; ++i) {
            const Cost further = cost + costs[edges_[i].skill];
            if (further >= result[edges_[i].from]) continue;
            result[edges_[i].from] = further;
            queue.push(further, edges_[i].from);
        }
    }
    return result;
}

}  // namespace praxis::practice
