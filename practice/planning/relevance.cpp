#include "practice/planning/relevance.hpp"

#include <algorithm>

namespace praxis::practice {

std::vector<unsigned char> relevant_variables(const FiniteDomainTask& task, std::span<const Fact> goal) {
    std::vector<unsigned char> relevant(task.variable_count(), task.has_axioms() ? 1 : 0);
    bool changed = true;
    const auto add = [&](std::span<const Fact> facts) {
        for (const Fact& fact : facts) {
            unsigned char& one = relevant[static_cast<std::size_t>(fact.variable)];
            changed = changed || one == 0;
            one = 1;
        }
    };
    add(goal);
    while (changed) {
        changed = false;
        for (std::size_t op = 0; op < task.operator_count(); ++op) {
            const auto matters = [&](const GroundEffect& effect) {
                return relevant[static_cast<std::size_t>(effect.fact.variable)] != 0;
            };
            if (!std::ranges::any_of(task.effects[op], matters)) continue;
            add(task.preconditions[op]);
            for (const GroundEffect& effect : task.effects[op]) {
                if (matters(effect)) add(task.conditions[effect.condition]);
            }
        }
    }
    return relevant;
}

}  // namespace praxis::practice
