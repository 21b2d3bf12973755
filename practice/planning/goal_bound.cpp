#include "practice/planning/goal_bound.hpp"

#include <algorithm>

namespace praxis::practice {

namespace {

bool changes(const FiniteDomainTask& task, std::size_t skill, std::int32_t variable) {
    return std::ranges::any_of(task.effects[skill],
                               [&](const GroundEffect& effect) { return effect.fact.variable == variable; });
}

bool can_be_projected_onto(const FiniteDomainTask& task, std::int32_t variable) {
    const auto values = static_cast<std::size_t>(task.domain_sizes[static_cast<std::size_t>(variable)]);
    return !task.derived(variable) && values <= StateProjection::kMostStates;
}

}  // namespace

const StateProjection& Projections::onto(std::int32_t variable) {
    projections_.resize(graph_->task().variable_count());
    auto& projection = projections_[static_cast<std::size_t>(variable)];
    if (!projection || projection->nodes() != graph_->size())
        projection = std::make_unique<const StateProjection>(*graph_, variable);
    return *projection;
}

GoalBound::GoalBound(const FiniteDomainTask& task, Projections& projections, std::span<const Fact> goal,
                     std::span<const Cost> costs) {
    std::vector<Fact> facts;
    for (const Fact& fact : goal) {
        if (can_be_projected_onto(task, fact.variable)) facts.push_back(fact);
    }
    std::vector<std::size_t> counted_for(costs.size(), 0);
    for (std::size_t skill = 0; skill < costs.size(); ++skill) {
        const auto first = std::ranges::find_if(
            facts, [&](const Fact& fact) { return changes(task, skill, fact.variable); });
        if (first != facts.end()) counted_for[skill] = static_cast<std::size_t>(first - facts.begin());
    }
    for (std::size_t i = 0; i < facts.size(); ++i) {
        std::vector<Cost> counted(costs.size(), 0);
        for (std::size_t skill = 0; skill < costs.size(); ++skill) {
            if (counted_for[skill] == i) counted[skill] = costs[skill];
        }
        const StateProjection& projection = projections.onto(facts[i].variable);
        parts_.push_back({&projection, projection.distances(facts[i], counted)});
    }
}

}  // namespace praxis::practice
