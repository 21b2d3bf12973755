// What is known of derived atoms, from what is known of the others.
//
// An atom is known to hold if the axioms say so of what is known, and known not to hold if they do not say so
// even of what is possible. That is sound, and blind to reasoning by cases.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "belief/belief_task.hpp"

namespace praxis::belief {

class DerivedKnowledge {
  public:
    /// Refers to the task.
    explicit DerivedKnowledge(const BeliefTask& task);

    /// Anew from `value(variable)`: the known value of a variable that is not derived, or
    /// BeliefTask::kUnknown.
    template <class Value>
    void update(const Value& value);

    /// The known value of a derived variable, or BeliefTask::kUnknown.
    std::int32_t value(std::int32_t variable) const {
        const auto v = static_cast<std::size_t>(variable);
        const std::int32_t otherwise = task_->physical->initial_values[v];
        return known_[v] ? 1 - otherwise : possible_[v] ? BeliefTask::kUnknown : otherwise;
    }

  private:
    const BeliefTask* task_;
    std::vector<std::vector<std::uint32_t>> layers_;  ///< axioms by layer
    std::vector<char> known_, possible_;              ///< by variable: that it has not its default value
};

template <class Value>
void DerivedKnowledge::update(const Value& value) {
    const FiniteDomainTask& task = *task_->physical;
    std::fill(known_.begin(), known_.end(), 0);
    std::fill(possible_.begin(), possible_.end(), 0);
    const auto known = [&](const Fact& fact) {
        if (!task.derived(fact.variable)) return value(fact.variable) == fact.value;
        const auto v = static_cast<std::size_t>(fact.variable);
        return fact.value == task.initial_values[v] ? possible_[v] == 0 : known_[v] != 0;
    };
    const auto possible = [&](const Fact& fact) {
        if (!task.derived(fact.variable)) {
            const std::int32_t now = value(fact.variable);
            return now == fact.value || now == BeliefTask::kUnknown;
        }
        const auto v = static_cast<std::size_t>(fact.variable);
        return fact.value == task.initial_values[v] ? known_[v] == 0 : possible_[v] != 0;
    };
    for (const std::vector<std::uint32_t>& layer : layers_) {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::uint32_t axiom : layer) {
                const auto head = static_cast<std::size_t>(task.axioms[axiom].head.variable);
                const auto body = task.axiom_bodies[axiom];
                if (!known_[head] && std::all_of(body.begin(), body.end(), known))
                    known_[head] = changed = true;
                if (!possible_[head] && std::all_of(body.begin(), body.end(), possible))
                    possible_[head] = changed = true;
            }
        }
    }
}

}  // namespace praxis::belief
