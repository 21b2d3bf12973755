#include "search/state/transitions.hpp"

namespace praxis {

Transitions::Transitions(const FiniteDomainTask& task, const StatePacker& packer)
    : task_(&task), packer_(&packer), conditional_(task.operator_count(), false) {
    if (!task.has_conditional_effects()) return;
    for (std::size_t i = 0; i < task.operator_count(); ++i) {
        for (const GroundEffect& effect : task.effects[i]) {
            if (effect.condition != 0) conditional_[i] = true;
        }
    }
}

}  // namespace praxis
