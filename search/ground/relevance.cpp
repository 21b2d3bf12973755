#include "search/ground/relevance.hpp"

#include <algorithm>
#include <utility>

namespace praxis::grounding {
namespace {

std::vector<bool> relevant_variables(const FiniteDomainTask& task) {
    const std::size_t count = task.variable_count();
    PackedLists<std::uint32_t> operators_of;
    {
        std::vector<std::vector<std::uint32_t>> lists(count);
        for (std::size_t o = 0; o < task.operator_count(); ++o)
            for (const GroundEffect& effect : task.effects[o]) {
                auto& list = lists[static_cast<std::size_t>(effect.fact.variable)];
                if (list.empty() || list.back() != o) list.push_back(static_cast<std::uint32_t>(o));
            }
        for (auto& list : lists) operators_of.append(list);
    }
    std::vector<std::vector<std::uint32_t>> axioms_of(count);
    for (std::size_t a = 0; a < task.axioms.size(); ++a)
        axioms_of[static_cast<std::size_t>(task.axioms[a].head.variable)].push_back(
            static_cast<std::uint32_t>(a));

    std::vector<bool> relevant(count, false);
    std::vector<std::int32_t> queue;
    const auto add = [&](std::span<const Fact> facts) {
        for (Fact fact : facts) {
            if (relevant[static_cast<std::size_t>(fact.variable)]) continue;
            relevant[static_cast<std::size_t>(fact.variable)] = true;
            queue.push_back(fact.variable);
        }
    };
    add(task.goal);
    std::vector<bool> met(task.operator_count(), false);
    while (!queue.empty()) {
        const std::int32_t variable = queue.back();
        queue.pop_back();
        for (std::uint32_t o : operators_of[static_cast<std::size_t>(variable)]) {
            if (!met[o]) add(task.preconditions[o]);
            met[o] = true;
            for (const GroundEffect& effect : task.effects[o])
                if (effect.fact.variable == variable) add(task.conditions[effect.condition]);
        }
        for (std::uint32_t a : axioms_of[static_cast<std::size_t>(variable)]) add(task.axiom_bodies[a]);
    }
    return relevant;
}

class Restriction {
  public:
    Restriction(FiniteDomainTask task, std::vector<bool> relevant)
        : old_(std::move(task)), relevant_(std::move(relevant)) {}

    FiniteDomainTask run() {
        restrict_variables();
        restrict_operators();
        for (std::size_t a = 0; a < old_.axioms.size(); ++a) {
            if (!kept(old_.axioms[a].head)) continue;
            made_.axioms.push_back({renamed(old_.axioms[a].head)});
            made_.axiom_bodies.append(renamed(old_.axiom_bodies[a]));
        }
        made_.goal = renamed(old_.goal);
        for (std::size_t g = 0; g < old_.mutex_groups.size(); ++g) {
            std::vector<Fact> facts = renamed(old_.mutex_groups[g]);
            if (facts.size() > 1) made_.mutex_groups.append(facts);
        }
        made_.unit_cost = old_.unit_cost;
        made_.cost_scale = old_.cost_scale;
        made_.proved_unsolvable = old_.proved_unsolvable;
        return std::move(made_);
    }

  private:
    bool kept(Fact fact) const { return relevant_[static_cast<std::size_t>(fact.variable)]; }
    Fact renamed(Fact fact) const { return {number_[static_cast<std::size_t>(fact.variable)], fact.value}; }
    std::vector<Fact> renamed(std::span<const Fact> facts) const {
        std::vector<Fact> result;
        for (Fact fact : facts)
            if (kept(fact)) result.push_back(renamed(fact));
        return result;
    }

    void restrict_variables() {
        made_.fact_names.symbols = std::move(old_.fact_names.symbols);
        std::uint32_t facts = 0;
        for (std::size_t v = 0; v < old_.variable_count(); ++v) {
            number_.push_back(static_cast<std::int32_t>(made_.variable_count()));
            if (!relevant_[v]) continue;
            made_.domain_sizes.push_back(old_.domain_sizes[v]);
            made_.axiom_layers.push_back(old_.axiom_layers[v]);
            made_.initial_values.push_back(old_.initial_values[v]);
            made_.first_fact.push_back(facts);
            facts += static_cast<std::uint32_t>(old_.domain_sizes[v]);
            for (std::uint32_t f = old_.first_fact[v]; f < old_.first_fact[v + 1]; ++f) {
                made_.fact_names.names.append(old_.fact_names.names[f]);
                made_.fact_forms.push_back(old_.fact_forms[f]);
            }
        }
        made_.first_fact.push_back(facts);
    }

    void restrict_operators() {
        made_.operator_names.symbols = std::move(old_.operator_names.symbols);
        made_.conditions.close();
        std::vector<GroundEffect> effects;
        for (std::size_t o = 0; o < old_.operator_count(); ++o) {
            effects.clear();
            for (GroundEffect effect : old_.effects[o]) {
                if (!kept(effect.fact)) continue;
                if (effect.condition != 0) {
                    const auto condition = renamed(old_.conditions[effect.condition]);
                    effect.condition = static_cast<std::uint32_t>(made_.conditions.size());
                    made_.conditions.append(condition);
                }
                effects.push_back({renamed(effect.fact), effect.condition});
            }
            if (effects.empty()) continue;
            made_.preconditions.append(renamed(old_.preconditions[o]));
            made_.effects.append(effects);
            made_.costs.push_back(old_.costs[o]);
            made_.operator_names.names.append(old_.operator_names.names[o]);
        }
    }

    FiniteDomainTask old_;
    std::vector<bool> relevant_;
    FiniteDomainTask made_;
    std::vector<std::int32_t> number_;
};

}  // namespace

FiniteDomainTask without_irrelevant(FiniteDomainTask task) {
    std::vector<bool> relevant = relevant_variables(task);
    if (std::find(relevant.begin(), relevant.end(), false) == relevant.end()) return task;
    return Restriction(std::move(task), std::move(relevant)).run();
}

}  // namespace praxis::grounding
