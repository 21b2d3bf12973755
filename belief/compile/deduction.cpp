#include "belief/compile/compiler.hpp"

namespace praxis::belief {
namespace {

constexpr std::size_t kLargestAxiomGroup = 40;
/// What can be read is deduced by longer clauses in the belief only, not in plans.
constexpr std::size_t kLongestClause = 6;

}  // namespace

void Compiler::find_changeable() {
    changeable_.assign(physical_.variable_count(), false);
    for (const GroundEffect& effect : physical_.effects.items())
        changeable_[index(effect.fact.variable)] = true;
    for (std::int32_t variable : belief_.forgotten.items()) changeable_[index(variable)] = true;
    readable_.assign(physical_.variable_count(), false);
    for (const GroundReading& reading : belief_.readings.items())
        readable_[index(reading.fact.variable)] = true;
    for (const GroundSensor& sensor : belief_.sensors) readable_[index(sensor.reading.fact.variable)] = true;
}

std::size_t Compiler::guard(std::span<const Fact> facts, bool invariant) {
    if (invariant || std::none_of(facts.begin(), facts.end(),
                                  [&](const Fact& fact) { return changeable_[index(fact.variable)]; }))
        return kAlways;
    CompiledClause clause{-1, {}};
    for (const Fact& fact : facts) {
        clause.about.push_back(fact.variable);
        guards_of_[index(fact.variable)].push_back(static_cast<std::uint32_t>(result_.clauses_.size()));
    }
    result_.clauses_.push_back(std::move(clause));
    return result_.clauses_.size() - 1;
}

void Compiler::collect_axioms() {
    guards_of_.resize(physical_.variable_count());
    deduced_.assign(physical_.fact_count(), false);
    reasons_.resize(physical_.fact_count());
    for (std::size_t c = 0; c < belief_.clauses.size(); ++c) {
        const auto clause = belief_.clauses[c];
        if (tracked(clause.front().variable)) continue;
        const std::size_t while_open = guard(clause, belief_.invariant_clauses[c]);
        for (const Fact& head : clause) {
            if (!uncertain(head.variable)) continue;
            if (clause.size() > kLongestClause && readable_[index(head.variable)]) continue;
            Condition body;
            for (const Fact& other : clause)
                if (other != head) body.push_back(opposite(other));
            add_deduction(head, {std::move(body), while_open});
        }
    }
    std::vector<bool> from_clauses = deduced_;
    for (std::size_t g = 0; g < belief_.groups.size(); ++g) {
        const auto group = belief_.groups[g];
        if (group.size() > kLargestAxiomGroup || tracked(group.front().variable)) continue;
        if (std::none_of(group.begin(), group.end(),
                         [&](const Fact& fact) { return from_clauses[number(fact)]; }))
            continue;
        const std::size_t while_open = guard(group, belief_.invariant_groups[g]);
        for (const Fact& holding : group)
            for (const Fact& other : group)
                if (other != holding && uncertain(other.variable))
                    add_deduction(opposite(other), {{holding}, while_open});
    }
    const auto need = [&](std::span<const Fact> facts) {
        for (const Fact& fact : facts)
            if (uncertain(fact.variable) && !physical_.derived(fact.variable) && !tracked(fact.variable))
                deduced_[number(opposite(fact))] = true;
    };
    for (const GroundEffect& effect : physical_.effects.items())
        if (effect.condition != 0) need(physical_.conditions[effect.condition]);
    for (std::size_t a = 0; a < physical_.axioms.size(); ++a)
        if (uncertain(physical_.axioms[a].head.variable)) need(physical_.axiom_bodies[a]);
}

void Compiler::add_deduction(Fact head, Reason reason) {
    deduced_[number(head)] = true;
    reasons_[number(head)].push_back(std::move(reason));
}

void Compiler::add_axiom(Fact head, Condition body) {
    const auto sorted = conjunction(std::move(body));
    if (!sorted) return;
    task_->axioms.push_back({head});
    task_->axiom_bodies.append(*sorted);
}

void Compiler::make_axioms() {
    for (std::size_t v = 0; v < physical_.variable_count(); ++v) {
        const auto variable = static_cast<std::int32_t>(v);
        if (!uncertain(variable) || physical_.derived(variable) || tracked(variable)) continue;
        const std::int32_t basic = result_.variables_[v];
        for (const Fact fact : {Fact{variable, 0}, Fact{variable, 1}}) {
            if (!deduced_[number(fact)]) continue;
            add_axiom(known(fact), {{basic, fact.value}});
            for (const Reason& reason : reasons_[number(fact)]) {
                // What is known by an effect is not deduced from the first state.
                Condition body{{basic, Compilation::kNotKnown}};
                for (const Fact& other : reason.facts) body.push_back(known(other));
                if (reason.clause != kAlways) body.push_back({result_.clauses_[reason.clause].variable, 0});
                add_axiom(known(fact), std::move(body));
            }
        }
    }
    for (std::size_t a = 0; a < physical_.axioms.size(); ++a) {
        const Fact head = physical_.axioms[a].head;
        Condition body;
        for (const Fact& fact : physical_.axiom_bodies[a]) body.push_back(known(fact));
        add_axiom(known(head), std::move(body));
        if (!uncertain(head.variable)) continue;
        Condition maybe;
        for (const Fact& fact : physical_.axiom_bodies[a]) maybe.push_back(possible(fact));
        add_axiom(possible_[number(head)], std::move(maybe));
    }
}

const std::vector<Fact>& Compiler::implied(Fact fact) {
    if (implied_done_[number(fact)]) return implied_[number(fact)];
    implied_done_[number(fact)] = true;
    if (neighbours_.empty()) index_implications();
    std::vector<Fact> reached{fact};
    std::vector<bool> seen(physical_.fact_count(), false);
    seen[number(fact)] = true;
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const auto follow = [&](Fact next) {
            if (seen[number(next)]) return;
            seen[number(next)] = true;
            reached.push_back(next);
        };
        for (const Fact& next : neighbours_[number(reached[i])]) follow(next);
        for (std::uint32_t group : groups_of_[number(reached[i])])
            for (const Fact& other : belief_.groups[group])
                if (other != reached[i]) follow(opposite(other));
    }
    std::vector<Fact>& result = implied_[number(fact)];
    for (std::size_t i = 1; i < reached.size(); ++i)
        if (uncertain(reached[i].variable) && !seen[number(opposite(reached[i]))])
            result.push_back(reached[i]);
    return result;
}

void Compiler::index_implications() {
    neighbours_.resize(physical_.fact_count());
    groups_of_.resize(physical_.fact_count());
    for (std::size_t c = 0; c < belief_.clauses.size(); ++c) {
        const auto clause = belief_.clauses[c];
        if (clause.size() != 2) continue;
        neighbours_[number(opposite(clause[0]))].push_back(clause[1]);
        neighbours_[number(opposite(clause[1]))].push_back(clause[0]);
    }
    for (std::size_t g = 0; g < belief_.groups.size(); ++g)
        for (const Fact& fact : belief_.groups[g])
            if (uncertain(fact.variable)) groups_of_[number(fact)].push_back(static_cast<std::uint32_t>(g));
}

}  // namespace praxis::belief
