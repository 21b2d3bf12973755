// A graph whose edges are ground skills, in flat arrays: by node forward and backward, and by skill.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "practice/planning/skill_task.hpp"

namespace praxis::practice {

using NodeIndex = std::uint32_t;

class SkillGraph {
  public:
    struct Edge {
        SkillIndex skill;
        NodeIndex node;  ///< forward: where it leads to; backward: where it comes from
    };
    struct Arc {
        NodeIndex from, to;
    };

    /// Edges are added node by node, in the order of the nodes.
    void add_edge(SkillIndex skill, NodeIndex to) { edges_.push_back({skill, to}); }
    void close_node() { first_edge_.push_back(edges_.size()); }
    /// Makes `backward` and `arcs` of all edges so far.
    void index(std::size_t skills);
    void clear();

    /// Nodes closed so far.
    std::size_t size() const { return first_edge_.size() - 1; }
    std::size_t edge_count() const { return edges_.size(); }
    std::span<const Edge> forward(NodeIndex node) const {
        return {edges_.data() + first_edge_[node], edges_.data() + first_edge_[node + 1]};
    }
    std::span<const Edge> backward(NodeIndex node) const {
        return {backward_.data() + first_backward_[node], backward_.data() + first_backward_[node + 1]};
    }
    std::span<const Arc> arcs(SkillIndex skill) const {
        return {arcs_.data() + first_arc_[skill], arcs_.data() + first_arc_[skill + 1]};
    }

  private:
    std::vector<std::size_t> first_edge_{0};
    std::vector<Edge> edges_;
    std::vector<std::size_t> first_backward_;
    std::vector<Edge> backward_;
    std::vector<std::size_t> first_arc_;
    std::vector<Arc> arcs_;
};

}  // namespace praxis::practice
