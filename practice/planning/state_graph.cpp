#include "practice/planning/state_graph.hpp"

#include <algorithm>

namespace praxis::practice {

StateGraph::StateGraph(const SkillTask& skills, std::span<const unsigned char> relevant,
                       std::size_t most_states)
    : skills_(&skills),
      parts_(&skills.prepared()->parts()),
      registry_(parts_->packer, 0),
      most_states_(most_states),
      first_edge_{0} {
    const FiniteDomainTask& task = skills.task();
    for (std::size_t variable = 0; variable < relevant.size(); ++variable) {
        if (relevant[variable] == 0)
            fixed_.push_back({static_cast<std::int32_t>(variable), task.initial_values[variable]});
    }
    for (std::size_t op = 0; op < task.operator_count(); ++op) {
        const bool any = std::ranges::any_of(task.effects[op], [&](const GroundEffect& effect) {
            return relevant[static_cast<std::size_t>(effect.fact.variable)] != 0;
        });
        matters_.push_back(any ? 1 : 0);
    }
}

bool StateGraph::reach(const std::vector<std::int32_t>& values, NodeIndex& node) {
    if (overflowed_) return false;
    parts_->packer.pack(values.data(), registry_.candidate());
    for (const Fact& fact : fixed_) parts_->packer.set(registry_.candidate(), fact);
    const auto [state, added] = registry_.intern();
    node = static_cast<NodeIndex>(state.index());
    if (added) expand_all();
    return !overflowed_;
}

void StateGraph::expand_all() {
    std::vector<std::int32_t> values(skills_->task().variable_count());
    AxiomEvaluator::Scratch scratch;
    for (std::size_t node = first_edge_.size() - 1; node < registry_.size(); ++node) {
        if (registry_.size() > most_states_) {
            overflowed_ = true;
            return;
        }
        const StateId state(static_cast<std::uint32_t>(node));
        parts_->packer.unpack(registry_.words(state), values.data());
        parts_->axioms.complete(values.data(), scratch);
        parts_->generator.for_each(values.data(), [&](OperatorId id) {
            if (matters_[id.index()] == 0) return;
            std::uint32_t* after = registry_.candidate_from(state);
            parts_->transitions.apply(id, values.data(), after);
            for (const Fact& fact : fixed_) parts_->packer.set(after, fact);
            const auto [child, added] = registry_.intern();
            if (child != state)
                edges_.push_back(
                    {static_cast<SkillIndex>(id.index()), static_cast<NodeIndex>(child.index())});
        });
        first_edge_.push_back(edges_.size());
    }
    index_edges();
}

void StateGraph::index_edges() {
    const std::size_t nodes = size();
    first_backward_.assign(nodes + 1, 0);
    first_arc_.assign(skills_->size() + 1, 0);
    for (const Edge& edge : edges_) {
        ++first_backward_[edge.node + 1];
        ++first_arc_[edge.skill + 1];
    }
    for (std::size_t i = 0; i < nodes; ++i) first_backward_[i + 1] += first_backward_[i];
    for (std::size_t i = 0; i < skills_->size(); ++i) first_arc_[i + 1] += first_arc_[i];
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

std::vector<NodeIndex> StateGraph::where(std::span<const Fact> facts) const {
    bool derived = false;
    for (const Fact& fact : facts) derived |= skills_->task().derived(fact.variable);
    std::vector<std::int32_t> values(skills_->task().variable_count());
    AxiomEvaluator::Scratch scratch;
    std::vector<NodeIndex> nodes;
    for (NodeIndex node = 0; node < size(); ++node) {
        const std::uint32_t* words = registry_.words(StateId(node));
        bool all = true;
        if (derived) {
            parts_->packer.unpack(words, values.data());
            parts_->axioms.complete(values.data(), scratch);
            all = all_hold(facts, values.data());
        } else {
            for (const Fact& fact : facts)
                all = all && parts_->packer.get(words, fact.variable) == fact.value;
        }
        if (all) nodes.push_back(node);
    }
    return nodes;
}

}  // namespace praxis::practice
