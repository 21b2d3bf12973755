#include "practice/planning/skill_graph.hpp"

namespace praxis::practice {

void SkillGraph::clear() {
    first_edge_.assign(1, 0);
    edges_.clear();
}

void SkillGraph::index(std::size_t skills) {
    const std::size_t nodes = size();
    first_backward_.assign(nodes + 1, 0);
    first_arc_.assign(skills + 1, 0);
    for (const Edge& edge : edges_) {
        ++first_backward_[edge.node + 1];
        ++first_arc_[edge.skill + 1];
    }
    for (std::size_t i = 0; i < nodes; ++i) first_backward_[i + 1] += first_backward_[i];
    for (std::size_t i = 0; i < skills; ++i) first_arc_[i + 1] += first_arc_[i];
    backward_.resize(edges_.size());
    arcs_.resize(edges_.size());
    std::vector<std::size_t> next_backward(first_backward_.begin(), first_backward_.end() - 1);
    std::vector<std::size_t> next_arc(first_arc_.begin(), first_arc_.end() - 1);
    for (NodeIndex node = 0; node < nodes; ++node) {
        for (const Edge& edge : forward(node)) {
            backward_[next_backward[edge.node]++] = {edge.skill, node};
            arcs_[next_arc[edge.skill]++] = {node, edge.node};
        }
    }
}

}  // namespace praxis::practice
