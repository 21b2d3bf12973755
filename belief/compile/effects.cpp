#include "belief/compile/compiler.hpp"

namespace praxis::belief {

std::uint32_t Compiler::condition(const Condition& facts) {
    if (facts.empty()) return 0;
    const auto [place, fresh] = conditions_.emplace(facts, static_cast<std::uint32_t>(0));
    if (fresh) {
        place->second = static_cast<std::uint32_t>(task_->conditions.size());
        task_->conditions.append(facts);
    }
    return place->second;
}

void Compiler::add_effect(std::vector<GroundEffect>& effects, Fact fact, Condition facts) {
    if (const auto sorted = conjunction(std::move(facts))) effects.push_back({fact, condition(*sorted)});
}

std::vector<GroundEffect> Compiler::knowledge_effects(std::size_t o) {
    const auto precondition = physical_.preconditions[o];
    const auto given = [&](Fact fact) {
        return std::find(precondition.begin(), precondition.end(), fact) != precondition.end();
    };
    const auto excluded = [&](Fact fact) {
        return std::any_of(precondition.begin(), precondition.end(), [&](const Fact& other) {
            return other.variable == fact.variable && other.value != fact.value;
        });
    };
    struct Change {
        Fact fact;
        Condition reason;  ///< without what the precondition says and what speaks of the variable itself
    };
    std::vector<Change> changes;
    std::vector<GroundEffect> result;
    for (const GroundEffect& effect : physical_.effects[o]) {
        const auto when = physical_.conditions[effect.condition];
        if (std::any_of(when.begin(), when.end(), excluded)) continue;
        Condition reason;
        for (const Fact& fact : when)
            if (!given(fact)) reason.push_back(fact);
        const std::int32_t variable = effect.fact.variable;
        if (!uncertain(variable)) {
            for (Fact& fact : reason) fact = known(fact);
            add_effect(result, known(effect.fact), std::move(reason));
            continue;
        }
        if (tracked(variable)) {
            for (std::size_t slot = 0; slot < slots_of(variable).possible.size(); ++slot) {
                Condition here;
                for (const Fact& fact : reason)
                    here.push_back(uncertain(fact.variable) ? in_slot(fact, slot) : known(fact));
                add_effect(result, in_slot(effect.fact, slot), std::move(here));
            }
            continue;
        }
        // Where it must be the other value to change, it is the new one afterwards in any case.
        const bool single = alone(o, variable);
        if (single) std::erase(reason, opposite(effect.fact));
        if (std::find(reason.begin(), reason.end(), effect.fact) != reason.end() && single) continue;
        changes.push_back({effect.fact, std::move(reason)});
    }
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const auto& [fact, reason] = changes[i];
        const std::int32_t basic = result_.variables_[index(fact.variable)];
        const bool doubtful = std::any_of(reason.begin(), reason.end(),
                                          [&](const Fact& other) { return uncertain(other.variable); });
        if (doubtful) {
            Condition maybe;
            for (const Fact& other : reason) maybe.push_back(possible(other));
            const Fact unknown{basic, Compilation::kNotKnown};
            Condition against = maybe;
            against.push_back({basic, 1 - fact.value});
            add_effect(result, unknown, std::move(against));
            for (std::size_t j = 0; j < i; ++j) {
                if (changes[j].fact != opposite(fact)) continue;
                Condition both = maybe;
                for (const Fact& other : changes[j].reason) both.push_back(possible(other));
                add_effect(result, unknown, std::move(both));
            }
        }
        Condition sure;
        for (const Fact& other : reason) sure.push_back(known(other));
        add_effect(result, {basic, fact.value}, std::move(sure));
    }
    // Plans hope that what has cases stays as it is.
    for (std::int32_t variable : belief_.forgotten[o])
        if (!tracked(variable))
            add_effect(result, {result_.variables_[index(variable)], Compilation::kNotKnown}, {});
    close_clauses(o, result);
    return result;
}

void Compiler::close_clauses(std::size_t o, std::vector<GroundEffect>& effects) {
    std::set<std::int32_t> closed;
    const auto close = [&](std::int32_t variable) {
        for (std::uint32_t clause : guards_of_[index(variable)])
            closed.insert(result_.clauses_[clause].variable);
    };
    for (const GroundEffect& effect : physical_.effects[o]) close(effect.fact.variable);
    for (std::int32_t variable : belief_.forgotten[o]) close(variable);
    for (std::int32_t variable : closed) effects.push_back({{variable, 1}, 0});
}

bool Compiler::alone(std::size_t o, std::int32_t variable) const {
    const auto effects = physical_.effects[o];
    return std::count_if(effects.begin(), effects.end(),
                         [&](const GroundEffect& effect) { return effect.fact.variable == variable; }) == 1;
}

}  // namespace praxis::belief
