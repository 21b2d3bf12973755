#include "practice/planning/shortest_paths.hpp"

#include <algorithm>

namespace praxis::practice {

void ShortestPaths::to_goals(std::span<const NodeIndex> goals, std::span<const Cost> costs,
                             std::vector<Cost>& distances) {
    queue_.clear();
    distances.assign(graph_->size(), kNoPlan);
    for (NodeIndex node : goals) {
        distances[node] = 0;
        queue_.push(0, node);
    }
    while (!queue_.empty()) {
        const auto [cost, node] = queue_.pop();
        if (cost > distances[node]) continue;
        for (const StateGraph::Edge& edge : graph_->backward(node)) {
            const Cost distance = cost + costs[edge.skill];
            if (distance >= distances[edge.node]) continue;
            distances[edge.node] = distance;
            queue_.push(distance, edge.node);
        }
    }
}

bool ShortestPaths::way(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
                        std::vector<SkillIndex>& skills, Cost& cost) {
    skills.clear();
    goals_.reset(graph_->size());
    for (NodeIndex goal : goals) goals_.set(goal, 0);
    costs_.reset(graph_->size());
    parents_.resize(graph_->size());
    costs_.set(from, 0);
    queue_.clear();
    queue_.push(0, from);
    while (!queue_.empty()) {
        const auto [so_far, reached] = queue_.pop();
        if (so_far > costs_[reached]) continue;
        if (goals_[reached] == 0) {
            cost = so_far;
            for (NodeIndex node = reached; node != from; node = parents_[node].first)
                skills.push_back(parents_[node].second);
            std::ranges::reverse(skills);
            return true;
        }
        for (const StateGraph::Edge& edge : graph_->forward(reached)) {
            const Cost further = so_far + costs[edge.skill];
            if (!costs_.lower(edge.node, further)) continue;
            parents_[edge.node] = {reached, edge.skill};
            queue_.push(further, edge.node);
        }
    }
    return false;
}

}  // namespace praxis::practice
