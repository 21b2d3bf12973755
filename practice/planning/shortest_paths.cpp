#include "practice/planning/shortest_paths.hpp"

#include <algorithm>
#include <functional>

namespace praxis::practice {

void ShortestPaths::push(Cost distance, NodeIndex node) {
    heap_.push_back({distance, node});
    std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
}

ShortestPaths::Entry ShortestPaths::pop() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const Entry entry = heap_.back();
    heap_.pop_back();
    return entry;
}

void ShortestPaths::begin() {
    heap_.clear();
    ++stamp_;
    stamps_.resize(graph_->size(), 0);
    scratch_.resize(graph_->size());
    parents_.resize(graph_->size());
    goal_stamps_.resize(graph_->size(), 0);
}

void ShortestPaths::to_goals(std::span<const NodeIndex> goals, std::span<const Cost> costs,
                             std::vector<Cost>& distances) {
    heap_.clear();
    distances.assign(graph_->size(), kNoPlan);
    for (NodeIndex node : goals) {
        distances[node] = 0;
        heap_.push_back({0, node});
    }
    while (!heap_.empty()) {
        const Entry entry = pop();
        if (entry.distance > distances[entry.node]) continue;
        for (const StateGraph::Edge& edge : graph_->backward(entry.node)) {
            const Cost distance = entry.distance + costs[edge.skill];
            if (distance >= distances[edge.node]) continue;
            distances[edge.node] = distance;
            push(distance, edge.node);
        }
    }
}

bool ShortestPaths::way(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs,
                        std::vector<SkillIndex>& skills, Cost& cost) {
    begin();
    skills.clear();
    for (NodeIndex goal : goals) goal_stamps_[goal] = stamp_;
    stamps_[from] = stamp_;
    scratch_[from] = 0;
    push(0, from);
    while (!heap_.empty()) {
        const Entry entry = pop();
        if (entry.distance > scratch_[entry.node]) continue;
        if (goal_stamps_[entry.node] == stamp_) {
            cost = entry.distance;
            for (NodeIndex node = entry.node; node != from; node = parents_[node].first)
                skills.push_back(parents_[node].second);
            std::reverse(skills.begin(), skills.end());
            return true;
        }
        for (const StateGraph::Edge& edge : graph_->forward(entry.node)) {
            const Cost distance = entry.distance + costs[edge.skill];
            if (seen(edge.node) && distance >= scratch_[edge.node]) continue;
            stamps_[edge.node] = stamp_;
            scratch_[edge.node] = distance;
            parents_[edge.node] = {entry.node, edge.skill};
            push(distance, edge.node);
        }
    }
    return false;
}

void ShortestPaths::cheaper(std::span<const Cost> distances, std::span<const Cost> costs, SkillIndex skill,
                            Cost cost, std::span<const NodeIndex> nodes, std::span<Cost> result) {
    begin();
    const auto now = [&](NodeIndex node) { return seen(node) ? scratch_[node] : distances[node]; };
    const auto improve = [&](NodeIndex node, Cost distance) {
        if (distance >= now(node)) return;
        stamps_[node] = stamp_;
        scratch_[node] = distance;
        push(distance, node);
    };
    Cost farthest = 0;
    for (NodeIndex node : nodes) farthest = std::max(farthest, distances[node]);
    for (const StateGraph::Arc& arc : graph_->arcs(skill)) {
        if (distances[arc.to] != kNoPlan) improve(arc.from, distances[arc.to] + cost);
    }
    while (!heap_.empty()) {
        const Entry entry = pop();
        if (entry.distance >= farthest) break;
        if (entry.distance > scratch_[entry.node]) continue;
        for (const StateGraph::Edge& edge : graph_->backward(entry.node))
            improve(edge.node, entry.distance + (edge.skill == skill ? cost : costs[edge.skill]));
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) result[i] = now(nodes[i]);
}

}  // namespace praxis::practice
