#include "practice/planning/state_graph.hpp"

namespace praxis::practice {

StateGraph::StateGraph(const SkillTask& skills, std::size_t most_states)
    : skills_(&skills),
      parts_(&skills.prepared()->parts()),
      registry_(parts_->packer, 0),
      most_states_(most_states) {}

bool StateGraph::reach(const std::vector<std::int32_t>& values, NodeIndex& node) {
    if (overflowed_) return false;
    parts_->packer.pack(values.data(), registry_.candidate());
    const auto [state, added] = registry_.intern();
    node = static_cast<NodeIndex>(state.index());
    if (added) expand_all();
    return !overflowed_;
}

void StateGraph::expand_all() {
    std::vector<std::int32_t> values(skills_->task().variable_count());
    AxiomEvaluator::Scratch scratch;
    for (std::size_t node = graph_.size(); node < registry_.size(); ++node) {
        if (registry_.size() > most_states_) {
            overflowed_ = true;
            return;
        }
        const StateId state(static_cast<std::uint32_t>(node));
        parts_->packer.unpack(registry_.words(state), values.data());
        parts_->axioms.complete(values.data(), scratch);
        parts_->generator.for_each(values.data(), [&](OperatorId id) {
            parts_->transitions.apply(id, values.data(), registry_.candidate_from(state));
            const auto [child, added] = registry_.intern();
            if (child != state)
                graph_.add_edge(static_cast<SkillIndex>(id.index()), static_cast<NodeIndex>(child.index()));
        });
        graph_.close_node();
    }
    graph_.index(skills_->size());
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
