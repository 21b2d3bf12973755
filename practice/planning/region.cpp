#include "practice/planning/region.hpp"

#include <algorithm>

namespace praxis::practice {

Cost Region::begin(NodeIndex from, std::span<const NodeIndex> goals, std::span<const Cost> costs) {
    from_ = from;
    if (!whole_.way(from, goals, costs, plan_, cost_)) cost_ = kNoPlan;
    return cost_;
}

bool Region::make(std::span<const NodeIndex> goals, std::span<const Cost> costs, std::span<const Cost> lower,
                  std::size_t most) {
    if (!whole_.nearby(from_, lower, std::max<Cost>(cost_, 1), most, nodes_)) return false;
    numbers_.resize(graph_->size(), 0);
    for (std::size_t i = 0; i < nodes_.size(); ++i) numbers_[nodes_[i]] = static_cast<NodeIndex>(i);
    inside_.clear();
    goals_.clear();
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        for (const SkillGraph::Edge& edge : graph_->forward(nodes_[i])) {
            const NodeIndex number = numbers_[edge.node];
            if (number < nodes_.size() && nodes_[number] == edge.node) inside_.add_edge(edge.skill, number);
        }
        inside_.close_node();
        if (std::ranges::binary_search(goals, nodes_[i])) goals_.push_back(static_cast<NodeIndex>(i));
    }
    inside_.index(costs.size());
    part_.to_goals(goals_, costs, distances_);
    distances_[0] = cost_;
    return true;
}

Cost Region::improved(std::span<const Cost> costs, std::span<const NodeIndex> goals,
                      const Improvement& improvement) {
    const auto [skill, cost] = improvement;
    if (cost > costs[skill]) {
        if (std::ranges::find(plan_, skill) == plan_.end()) return cost_;
        std::vector<Cost> changed(costs.begin(), costs.end());
        changed[skill] = cost;
        std::vector<SkillIndex> plan;
        Cost result = kNoPlan;
        whole_.way(from_, goals, changed, plan, result);
        return result;
    }
    const NodeIndex first = 0;
    Cost result = cost_;
    part_.cheaper(distances_, costs, skill, cost, {&first, 1}, {&result, 1});
    return std::min(result, cost_);
}

}  // namespace praxis::practice
