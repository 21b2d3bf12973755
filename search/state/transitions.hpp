// What operators do to states.
#pragma once

#include <cstdint>
#include <vector>

#include "search/state/state_packer.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// Applies operators of one task. All effect conditions are read in the state before; of two effects on one
/// variable the later wins. Refers to the task and the packer.
class Transitions {
  public:
    Transitions(const FiniteDomainTask& task, const StatePacker& packer);

    /// Some effect of the operator has a condition, so that the values of the state before are needed.
    bool conditional(OperatorId id) const { return conditional_[id.index()]; }

    /// Turns a packed copy of the state before into the state after. `before` is complete; it may be null for
    /// operators that are not `conditional`.
    void apply(OperatorId id, const std::int32_t* before, std::uint32_t* words) const {
        for_each_fired(id, before, [&](Fact fact) { packer_->set(words, fact); });
    }
    /// The same on values; derived variables are left as they are. `before` and `values` do not overlap.
    void apply(OperatorId id, const std::int32_t* before, std::int32_t* values) const {
        for_each_fired(id, before, [&](Fact fact) { values[fact.variable] = fact.value; });
    }

  private:
    template <class Visit>
    void for_each_fired(OperatorId id, const std::int32_t* before, Visit&& visit) const {
        for (const GroundEffect& effect : task_->effects[id.index()]) {
            if (effect.condition == 0 || all_hold(task_->conditions[effect.condition], before))
                visit(effect.fact);
        }
    }

    const FiniteDomainTask* task_;
    const StatePacker* packer_;
    std::vector<bool> conditional_;
};

}  // namespace praxis
