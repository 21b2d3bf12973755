#include "belief/derived_knowledge.hpp"

namespace praxis::belief {

DerivedKnowledge::DerivedKnowledge(const BeliefTask& task)
    : task_(&task),
      known_(task.physical->variable_count(), 0),
      possible_(task.physical->variable_count(), 0) {
    const FiniteDomainTask& physical = *task.physical;
    for (std::size_t a = 0; a < physical.axioms.size(); ++a) {
        const auto layer = static_cast<std::size_t>(
            physical.axiom_layers[static_cast<std::size_t>(physical.axioms[a].head.variable)]);
        if (layers_.size() <= layer) layers_.resize(layer + 1);
        layers_[layer].push_back(static_cast<std::uint32_t>(a));
    }
}

}  // namespace praxis::belief
