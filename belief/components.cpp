#include "belief/components.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "belief/worlds.hpp"

namespace praxis::belief {
namespace {

class DisjointSets {
  public:
    explicit DisjointSets(std::size_t size) : parent_(size) {
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }
    std::size_t find(std::size_t item) {
        while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
        return item;
    }
    void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

  private:
    std::vector<std::size_t> parent_;
};

/// Forgotten variables without cases that could be counted beforehand. The values of multi-valued variables
/// can be, with what is defined by uncertain variables.
std::set<std::int32_t> untracked(const BeliefTask& task) {
    std::set<std::int32_t> result(task.forgotten.items().begin(), task.forgotten.items().end());
    for (const Fact& fact : task.choices.items()) result.erase(fact.variable);
    for (const GroundDefinition& definition : task.definitions) {
        const auto known = [&](const Fact& fact) { return !task.uncertain[index(fact.variable)]; };
        const auto& terms = definition.condition.terms();
        if (std::none_of(terms.begin(), terms.end(),
                         [&](const Dnf::Term& term) { return std::any_of(term.begin(), term.end(), known); }))
            result.erase(definition.fact.variable);
    }
    return result;
}

/// As many cases as there can be at any time, if some variable of the component is ever left open.
double most_ever(const BeliefTask& task, const Component& component) {
    const std::set<std::int32_t> forgotten(task.forgotten.items().begin(), task.forgotten.items().end());
    std::set<std::int32_t> free(component.variables.begin(), component.variables.end());
    if (std::none_of(free.begin(), free.end(), [&](std::int32_t v) { return forgotten.contains(v); }))
        return 0;
    double cases = 1;
    for (std::size_t c = 0; c < task.choices.size(); ++c) {
        if (free.erase(task.choices[c].front().variable) == 0) continue;
        cases *= static_cast<double>(task.choices[c].size());
        for (const Fact& fact : task.choices[c]) free.erase(fact.variable);
    }
    for (const GroundDefinition& definition : task.definitions) free.erase(definition.fact.variable);
    return cases * std::pow(2.0, static_cast<double>(free.size()));
}

}  // namespace

Components find_components(const BeliefTask& task, std::size_t most_cases) {
    const FiniteDomainTask& physical = *task.physical;
    const std::size_t count = physical.variable_count();
    DisjointSets sets(count);
    const auto uncertain = [&](const Fact& fact) {
        return static_cast<bool>(task.uncertain[index(fact.variable)]);
    };
    for (const auto* lists : {&task.clauses, &task.groups})
        for (std::size_t i = 0; i < lists->size(); ++i)
            for (const Fact& fact : (*lists)[i])
                sets.join(index(fact.variable), index((*lists)[i].front().variable));

    if (task.choices.size() > 0)
        for (const GroundDefinition& definition : task.definitions)
            for (const Dnf::Term& term : definition.condition.terms())
                for (const Fact& fact : term)
                    if (uncertain(fact)) sets.join(index(fact.variable), index(definition.fact.variable));

    // Effects that depend on what the precondition leaves open.
    std::vector<bool> dependent(count, false);
    for (std::size_t o = 0; o < physical.operator_count(); ++o) {
        const auto precondition = physical.preconditions[o];
        for (const GroundEffect& effect : physical.effects[o]) {
            for (const Fact& fact : physical.conditions[effect.condition]) {
                if (!uncertain(fact) ||
                    std::find(precondition.begin(), precondition.end(), fact) != precondition.end())
                    continue;
                sets.join(index(fact.variable), index(effect.fact.variable));
                dependent[index(effect.fact.variable)] = true;
            }
        }
    }
    // Where effects depend on derived atoms, cases would have to be derived: not tracked.
    std::vector<bool> wanted(count, false);
    for (const GroundEffect& effect : physical.effects.items())
        for (const Fact& fact : physical.conditions[effect.condition])
            if (uncertain(fact) && physical.derived(fact.variable)) wanted[index(fact.variable)] = true;
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t a = 0; a < physical.axioms.size(); ++a) {
            const std::size_t head = index(physical.axioms[a].head.variable);
            if (!wanted[head]) continue;
            for (const Fact& fact : physical.axiom_bodies[a]) {
                if (!uncertain(fact)) continue;
                sets.join(index(fact.variable), head);
                changed = changed || (physical.derived(fact.variable) && !wanted[index(fact.variable)]);
                wanted[index(fact.variable)] = true;
            }
        }
    }

    std::map<std::size_t, Component> found;
    for (std::size_t v = 0; v < count; ++v)
        if (dependent[v]) found[sets.find(v)];
    for (std::size_t v = 0; v < count; ++v)
        if (wanted[v] && physical.derived(static_cast<std::int32_t>(v))) found.erase(sets.find(v));
    for (std::size_t v = 0; v < count; ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (!task.uncertain[v] || physical.derived(variable)) continue;
        if (const auto place = found.find(sets.find(v)); place != found.end())
            place->second.variables.push_back(variable);
    }

    for (std::int32_t variable : untracked(task)) found.erase(sets.find(index(variable)));
    for (std::size_t v = 0; v < count; ++v)
        if (task.lasting[v] != BeliefTask::kForever) found.erase(sets.find(v));

    Components result;
    result.component_of.assign(count, Components::kNone);
    result.column_of.assign(count, Components::kNone);
    for (auto& [root, component] : found) {
        const auto rows = enumerate_values(task, component.variables, most_cases);
        if (!rows || rows->empty() || most_ever(task, component) > static_cast<double>(most_cases)) continue;
        component.cases = *rows;
        for (std::size_t i = 0; i < component.variables.size(); ++i) {
            result.component_of[index(component.variables[i])] =
                static_cast<std::uint32_t>(result.tracked.size());
            result.column_of[index(component.variables[i])] = static_cast<std::uint32_t>(i);
        }
        result.tracked.push_back(std::move(component));
    }
    return result;
}

}  // namespace praxis::belief
