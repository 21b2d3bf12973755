#include "practice/planning/improved_paths.hpp"

#include <algorithm>

namespace praxis::practice {

void ImprovedPaths::begin(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
                          std::span<const Cost> least, const GoalBound& bound,
                          std::span<const SkillIndex> plan, Cost plan_cost) {
    from_ = from;
    costs_ = costs;
    plan_ = plan;
    plan_cost_ = plan_cost;
    search_before(goals, least, bound);
    search_after(least);
}

void ImprovedPaths::search_before(std::span<const NodeIndex> goals, std::span<const Cost> least,
                                  const GoalBound& bound) {
    goals_.reset(graph_->size());
    for (const NodeIndex goal : goals) goals_.set(goal, 0);
    goals_met_.clear();
    before_.reset(graph_->size());
    before_.set(from_, 0);
    queue_.clear();
    queue_.push(0, from_);
    while (!queue_.empty()) {
        const auto [cost, node] = queue_.pop();
        if (cost > before_[node]) continue;
        if (goals_[node] == 0) {
            goals_met_.push_back(node);
            continue;
        }
        for (const StateGraph::Edge& edge : graph_->forward(node)) {
            const Cost further = cost + least[edge.skill];
            if (further >= before_[edge.node] || further >= plan_cost_ ||
                bound(edge.node) >= plan_cost_ - further)
                continue;
            before_.set(edge.node, further);
            queue_.push(further, edge.node);
        }
    }
}

void ImprovedPaths::search_after(std::span<const Cost> least) {
    chances_.clear();
    first_chance_.assign(costs_.size(), -1);
    after_.reset(graph_->size());
    queue_.clear();
    for (const NodeIndex goal : goals_met_) {
        after_.set(goal, 0);
        queue_.push(0, goal);
    }
    while (!queue_.empty()) {
        const auto [cost, node] = queue_.pop();
        if (cost > after_[node]) continue;
        for (const StateGraph::Edge& edge : graph_->backward(node)) {
            const Cost before = before_[edge.node];
            if (before >= plan_cost_ || goals_[edge.node] == 0) continue;
            const Cost room = plan_cost_ - before;
            const Cost nearest = cost + least[edge.skill];
            const Cost now = cost + costs_[edge.skill];
            if (nearest < now && nearest < room) {
                chances_.push_back({edge.node, node, first_chance_[edge.skill]});
                first_chance_[edge.skill] = static_cast<std::int32_t>(chances_.size()) - 1;
            }
            if (now < room && after_.lower(edge.node, now)) queue_.push(now, edge.node);
        }
    }
}

Cost ImprovedPaths::cost(const Improvement& improvement) {
    const auto [skill, cost] = improvement;
    const Cost gain = costs_[skill] - cost;
    Cost best = plan_cost_ - gain * std::ranges::count(plan_, skill);
    nearer_.reset(graph_->size());
    queue_.clear();
    const auto come_nearer = [&](NodeIndex node, Cost distance) {
        const Cost before = before_[node];
        if (before >= best || distance >= best - before || distance >= after_[node]) return;
        if (!nearer_.lower(node, distance)) return;
        queue_.push(distance, node);
        if (node == from_) best = distance;
    };
    for (std::int32_t i = first_chance_[skill]; i >= 0; i = chances_[static_cast<std::size_t>(i)].next) {
        const Chance& chance = chances_[static_cast<std::size_t>(i)];
        come_nearer(chance.from, after_[chance.to] + cost);
    }
    while (!queue_.empty()) {
        const auto [distance, node] = queue_.pop();
        if (distance >= best) break;
        if (distance > nearer_[node]) continue;
        for (const StateGraph::Edge& edge : graph_->backward(node))
            come_nearer(edge.node, distance + (edge.skill == skill ? cost : costs_[edge.skill]));
    }
    return best;
}

}  // namespace praxis::practice
