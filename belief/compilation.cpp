#include "belief/compilation.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace praxis::belief {
namespace {

/// Costs of the compiled task are in these units; a passive sensor's outcome costs one.
constexpr std::int64_t kActionUnit = 10;
constexpr std::size_t kLargestAxiomGroup = 40;
/// What can be read is deduced by longer clauses in the belief only, not in plans.
constexpr std::size_t kLongestClause = 6;

std::size_t index(std::int32_t value) {
    return static_cast<std::size_t>(value);
}
Fact opposite(Fact fact) {
    return {fact.variable, 1 - fact.value};
}

using Condition = std::vector<Fact>;

/// Sorted by variable; nothing if it contradicts itself.
std::optional<Condition> conjunction(Condition facts) {
    std::sort(facts.begin(), facts.end());
    facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
    for (std::size_t i = 1; i < facts.size(); ++i)
        if (facts[i - 1].variable == facts[i].variable) return std::nullopt;
    return facts;
}

}  // namespace

class Compiler {
  public:
    Compiler(Compilation& result, std::size_t slots)
        : result_(result),
          most_slots_(slots),
          belief_(*result.belief_),
          physical_(*belief_.physical),
          task_(std::make_shared<FiniteDomainTask>()) {}

    void run() {
        implied_.resize(physical_.fact_count());
        implied_done_.assign(physical_.fact_count(), false);
        find_changeable();
        collect_axioms();
        make_variables();
        make_axioms();
        find_moments();
        find_needed();
        make_operators();
        make_sensors();
        for (const Fact& fact : physical_.goal) task_->goal.push_back(known(fact));
        std::sort(task_->goal.begin(), task_->goal.end());
        add_mutex_groups();
        number_facts();
        task_->unit_cost = false;
        task_->cost_scale = physical_.cost_scale * kActionUnit;
        task_->proved_unsolvable = physical_.proved_unsolvable;
        result_.task_ = std::move(task_);
    }

  private:
    bool uncertain(std::int32_t variable) const { return belief_.uncertain[index(variable)]; }
    std::size_t number(Fact fact) const { return physical_.fact_number(fact); }
    bool tracked(std::int32_t variable) const { return result_.tracked(variable); }
    Fact known(Fact fact) {
        Fact& place = result_.known_[number(fact)];
        if (tracked(fact.variable) && place.variable < 0) place = known_in_all_cases(fact);
        return place;
    }

    /// The fact that says that a physical fact is possible. Its opposite must be derived knowledge if
    /// it is uncertain.
    Fact possible(Fact fact) {
        if (!uncertain(fact.variable)) return known(fact);
        if (tracked(fact.variable)) return possible_in_some_case(fact);
        if (physical_.derived(fact.variable)) return possible_[number(fact)];
        return {known(opposite(fact)).variable, 1};
    }

    void find_changeable() {
        changeable_.assign(physical_.variable_count(), false);
        for (const GroundEffect& effect : physical_.effects.items())
            changeable_[index(effect.fact.variable)] = true;
        for (std::int32_t variable : belief_.forgotten.items()) changeable_[index(variable)] = true;
        readable_.assign(physical_.variable_count(), false);
        for (const GroundReading& reading : belief_.readings.items())
            readable_[index(reading.fact.variable)] = true;
        for (const GroundSensor& sensor : belief_.sensors)
            readable_[index(sensor.reading.fact.variable)] = true;
    }

    /// The number of a clause or group as a variable of the compiled task, or kAlways if no action changes
    /// anything in it.
    std::size_t guard(std::span<const Fact> facts) {
        if (std::none_of(facts.begin(), facts.end(),
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

    /// Which knowledge can be deduced, and which is needed as a derived variable.
    void collect_axioms() {
        guards_of_.resize(physical_.variable_count());
        deduced_.assign(physical_.fact_count(), false);
        reasons_.resize(physical_.fact_count());
        for (std::size_t c = 0; c < belief_.clauses.size(); ++c) {
            const auto clause = belief_.clauses[c];
            if (tracked(clause.front().variable)) continue;
            const std::size_t while_open = guard(clause);
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
            const std::size_t while_open = guard(group);
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

    /// Why something is known: the facts of the condition are, and the clause still says something.
    struct Reason {
        Condition facts;
        std::size_t clause;
    };
    static constexpr std::size_t kAlways = static_cast<std::size_t>(-1);

    void add_deduction(Fact head, Reason reason) {
        deduced_[number(head)] = true;
        reasons_[number(head)].push_back(std::move(reason));
    }

    std::int32_t add_variable(std::int32_t size, std::int32_t layer, std::int32_t initial) {
        task_->domain_sizes.push_back(size);
        task_->axiom_layers.push_back(layer);
        task_->initial_values.push_back(initial);
        return static_cast<std::int32_t>(task_->domain_sizes.size()) - 1;
    }

    std::uint32_t symbol(const std::string& word) {
        const auto [place, fresh] =
            symbols_.emplace(word, static_cast<std::uint32_t>(task_->fact_names.symbols.size()));
        if (fresh) task_->fact_names.symbols.push_back(word);
        return place->second;
    }

    /// Names a fact "PREFIX physical-fact".
    void name(const char* prefix, std::optional<Fact> fact) {
        using Form = FiniteDomainTask::FactForm;
        if (!fact) {
            task_->fact_names.names.close();
            task_->fact_forms.push_back(Form::none_of_those);
            return;
        }
        Form form = physical_.fact_forms[number(*fact)];
        if (*prefix != 0) {
            std::string word = prefix;
            if (form == Form::negated_atom) word += "-not";
            task_->fact_names.names.add(symbol(word));
            form = Form::atom;
        }
        for (std::uint32_t word : physical_.fact_names.names[number(*fact)])
            task_->fact_names.names.add(symbol(physical_.fact_names.symbols[word]));
        task_->fact_names.names.close();
        task_->fact_forms.push_back(form);
    }

    void make_variables() {
        result_.known_.assign(physical_.fact_count(), {-1, 0});
        possible_.assign(physical_.fact_count(), {-1, 0});
        result_.variables_.assign(physical_.variable_count(), -1);
        for (std::size_t v = 0; v < physical_.variable_count(); ++v)
            make_variable(static_cast<std::int32_t>(v));
        for (std::size_t v = 0; v < physical_.variable_count(); ++v) {
            const auto variable = static_cast<std::int32_t>(v);
            if (!uncertain(variable) || physical_.derived(variable) || tracked(variable)) continue;
            for (const Fact fact : {Fact{variable, 0}, Fact{variable, 1}}) {
                if (!deduced_[number(fact)]) continue;
                const std::int32_t derived = add_variable(2, 0, 1);
                result_.known_[number(fact)] = {derived, 0};
                name("deduced", fact);
                name("", std::nullopt);
            }
        }
        for (CompiledClause& clause : result_.clauses_) {
            clause.variable = add_variable(2, -1, 0);
            name("", std::nullopt);
            name("", std::nullopt);
        }
        make_slots();
    }

    void number_facts() {
        task_->first_fact = {0};
        for (std::int32_t size : task_->domain_sizes)
            task_->first_fact.push_back(task_->first_fact.back() + static_cast<std::uint32_t>(size));
    }

    void make_slots() {
        for (const Component& component : result_.components_.tracked) {
            CompiledComponent compiled;
            for (std::size_t slot = 0; slot < std::min(component.count(), most_slots_); ++slot) {
                compiled.possible.push_back(add_variable(2, -1, 1));
                name("", std::nullopt);
                name("", std::nullopt);
                std::vector<std::int32_t>& row = compiled.values.emplace_back();
                for (std::size_t column = 0; column < component.variables.size(); ++column) {
                    row.push_back(
                        add_variable(2, -1, component.cases[slot * component.variables.size() + column]));
                    name("case", Fact{component.variables[column], 0});
                    name("case", Fact{component.variables[column], 1});
                }
            }
            result_.slots_.push_back(std::move(compiled));
        }
    }

    const CompiledComponent& slots_of(std::int32_t variable) const {
        return result_.slots_[result_.components_.component_of[index(variable)]];
    }
    Fact in_slot(Fact fact, std::size_t slot) const {
        return {slots_of(fact.variable).values[slot][result_.components_.column_of[index(fact.variable)]],
                fact.value};
    }

    Fact add_derived(const char* prefix, Fact fact) {
        const std::int32_t derived = add_variable(2, 0, 1);
        name(prefix, fact);
        name("", std::nullopt);
        return {derived, 0};
    }

    Fact known_in_all_cases(Fact fact) {
        const CompiledComponent& slots = slots_of(fact.variable);
        Condition all;
        for (std::size_t slot = 0; slot < slots.possible.size(); ++slot) {
            const Fact here = add_derived("known-in-case", fact);
            add_axiom(here, {{slots.possible[slot], 0}});
            add_axiom(here, {in_slot(fact, slot)});
            all.push_back(here);
        }
        const Fact everywhere = add_derived("known", fact);
        add_axiom(everywhere, std::move(all));
        return everywhere;
    }

    Fact possible_in_some_case(Fact fact) {
        Fact& place = possible_[number(fact)];
        if (place.variable >= 0) return place;
        place = add_derived("possible", fact);
        const CompiledComponent& slots = slots_of(fact.variable);
        for (std::size_t slot = 0; slot < slots.possible.size(); ++slot)
            add_axiom(place, {{slots.possible[slot], 1}, in_slot(fact, slot)});
        return place;
    }

    void make_variable(std::int32_t v) {
        const std::int32_t size = physical_.domain_sizes[index(v)];
        const std::int32_t layer = physical_.axiom_layers[index(v)];
        if (!uncertain(v)) {
            const std::int32_t made =
                add_variable(size, layer < 0 ? -1 : layer + 1, physical_.initial_values[index(v)]);
            result_.variables_[index(v)] = layer < 0 ? made : -1;
            for (std::int32_t value = 0; value < size; ++value) {
                result_.known_[number({v, value})] = {made, value};
                name("", Fact{v, value});
            }
        } else if (layer < 0 && !tracked(v)) {
            const std::int32_t start = belief_.initial_values[index(v)];
            const std::int32_t made =
                add_variable(3, -1, start == BeliefTask::kUnknown ? Compilation::kNotKnown : start);
            result_.variables_[index(v)] = made;
            for (std::int32_t value = 0; value < 2; ++value) {
                result_.known_[number({v, value})] = {made, value};
                name("known", Fact{v, value});
            }
            name("", std::nullopt);
        } else if (layer >= 0) {
            // A derived atom is known to hold if its axioms say so of what is known, and known not to hold
            // if they do not even of what is possible.
            const std::int32_t otherwise = physical_.initial_values[index(v)];
            const Fact holds{v, 1 - otherwise};
            const std::int32_t certain = add_variable(2, layer + 1, 1);
            name("known", holds);
            name("", std::nullopt);
            const std::int32_t maybe = add_variable(2, layer + 1, 1);
            name("possible", holds);
            name("", std::nullopt);
            result_.known_[number(holds)] = {certain, 0};
            possible_[number(holds)] = {maybe, 0};
            result_.known_[number({v, otherwise})] = {maybe, 1};
            possible_[number({v, otherwise})] = {certain, 1};
        }
    }

    void add_axiom(Fact head, Condition body) {
        const auto sorted = conjunction(std::move(body));
        if (!sorted) return;
        task_->axioms.push_back({head});
        task_->axiom_bodies.append(*sorted);
    }

    void make_axioms() {
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
                    if (reason.clause != kAlways)
                        body.push_back({result_.clauses_[reason.clause].variable, 0});
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

    std::uint32_t condition(const Condition& facts) {
        if (facts.empty()) return 0;
        const auto [place, fresh] = conditions_.emplace(facts, static_cast<std::uint32_t>(0));
        if (fresh) {
            place->second = static_cast<std::uint32_t>(task_->conditions.size());
            task_->conditions.append(facts);
        }
        return place->second;
    }

    void add_effect(std::vector<GroundEffect>& effects, Fact fact, Condition facts) {
        if (const auto sorted = conjunction(std::move(facts))) effects.push_back({fact, condition(*sorted)});
    }

    /// What an action does to knowledge, but for its readings.
    std::vector<GroundEffect> knowledge_effects(std::size_t o) {
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
        for (std::int32_t variable : belief_.forgotten[o])
            add_effect(result, {result_.variables_[index(variable)], Compilation::kNotKnown}, {});
        close_clauses(o, result);
        return result;
    }

    /// Nothing is deduced any more from clauses in which the action may change something.
    void close_clauses(std::size_t o, std::vector<GroundEffect>& effects) {
        std::set<std::int32_t> closed;
        const auto close = [&](std::int32_t variable) {
            for (std::uint32_t clause : guards_of_[index(variable)])
                closed.insert(result_.clauses_[clause].variable);
        };
        for (const GroundEffect& effect : physical_.effects[o]) close(effect.fact.variable);
        for (std::int32_t variable : belief_.forgotten[o]) close(variable);
        for (std::int32_t variable : closed) effects.push_back({{variable, 1}, 0});
    }

    /// Only one effect of the operator is about the variable.
    bool alone(std::size_t o, std::int32_t variable) const {
        const auto effects = physical_.effects[o];
        return std::count_if(effects.begin(), effects.end(), [&](const GroundEffect& effect) {
                   return effect.fact.variable == variable;
               }) == 1;
    }

    /// What else is known of the first state once `fact` is, by clauses of two and by groups.
    const std::vector<Fact>& implied(Fact fact) {
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

    void index_implications() {
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
                if (uncertain(fact.variable))
                    groups_of_[number(fact)].push_back(static_cast<std::uint32_t>(g));
    }

    void add_operator(const Condition& precondition, const std::vector<GroundEffect>& effects,
                      std::int64_t cost, CompiledOperator origin, const std::vector<std::uint32_t>& words) {
        const auto sorted = conjunction(precondition);
        if (!sorted) return;
        task_->preconditions.append(*sorted);
        task_->effects.append(effects);
        task_->costs.push_back(static_cast<std::int32_t>(std::min<std::int64_t>(cost, 1 << 30)));
        task_->operator_names.names.append(words);
        result_.origins_.push_back(origin);
    }

    /// Both outcomes of a reading.
    void add_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
                      std::int64_t cost, CompiledOperator origin, std::vector<std::uint32_t> words,
                      Fact read) {
        if (tracked(read.variable))
            return add_case_readings(precondition, effects, cost, origin, words, read);
        const std::int32_t basic = result_.variables_[index(read.variable)];
        for (const Fact& outcome : {read, opposite(read)}) {
            Condition needed = precondition;
            needed.push_back({basic, Compilation::kNotKnown});
            std::vector<GroundEffect> all = effects;
            for (const Fact& fact : implied(outcome))
                all.push_back({{result_.variables_[index(fact.variable)], fact.value}, 0});
            all.push_back({{basic, outcome.value}, 0});
            if (std::none_of(all.begin(), all.end(),
                             [&](const GroundEffect& effect) { return needed_.contains(effect.fact); }))
                continue;
            origin.reads = true;
            origin.outcome = outcome;
            add_operator(needed, all, cost, origin, words);
        }
    }

    void add_case_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
                           std::int64_t cost, CompiledOperator origin,
                           const std::vector<std::uint32_t>& words, Fact read) {
        const CompiledComponent& slots = slots_of(read.variable);
        for (const Fact& outcome : {read, opposite(read)}) {
            Condition needed = precondition;
            needed.push_back(possible(outcome));
            needed.push_back(possible(opposite(outcome)));
            std::vector<GroundEffect> all = effects;
            for (std::size_t slot = 0; slot < slots.possible.size(); ++slot)
                add_effect(all, {slots.possible[slot], 0}, {in_slot(opposite(outcome), slot)});
            origin.reads = true;
            origin.outcome = outcome;
            add_operator(needed, all, cost, origin, words);
        }
    }

    /// Actions whose readings are steps of their own: those with several, and those that read what they
    /// change.
    void find_moments() {
        moments_.assign(physical_.operator_count(), 0);
        std::int32_t count = 0;
        for (std::size_t o = 0; o < physical_.operator_count(); ++o) {
            std::size_t open = 0;
            bool changed = false;
            for (const GroundReading& reading : belief_.readings[o]) {
                open += uncertain(reading.fact.variable);
                for (const GroundEffect& effect : physical_.effects[o])
                    changed = changed || effect.fact.variable == reading.fact.variable;
            }
            if (open > 1 || changed) moments_[o] = ++count;
        }
        if (count == 0) return;
        result_.moment_ = add_variable(count + 1, -1, 0);
        for (std::int32_t value = 0; value <= count; ++value) name("", std::nullopt);
    }

    /// The knowledge that something asks for; a reading that can only tell something else is of no use in a
    /// plan.
    void find_needed() {
        const auto need = [&](std::span<const Fact> facts) {
            for (const Fact& fact : facts) needed_.insert(known(fact));
        };
        need(physical_.preconditions.items());
        need(physical_.goal);
        need(belief_.sensor_conditions.items());
        for (const Fact& fact : physical_.conditions.items()) {
            if (tracked(fact.variable)) continue;
            const Fact both[] = {fact, opposite(fact)};
            need(physical_.domain_sizes[index(fact.variable)] == 2 ? std::span(both)
                                                                   : std::span<const Fact>(&fact, 1));
        }
        needed_.insert(task_->axiom_bodies.items().begin(), task_->axiom_bodies.items().end());
    }

    void make_operators() {
        task_->conditions.close();
        task_->operator_names.symbols = physical_.operator_names.symbols;
        for (std::size_t o = 0; o < physical_.operator_count(); ++o) {
            Condition precondition;
            for (const Fact& fact : physical_.preconditions[o]) precondition.push_back(known(fact));
            std::vector<GroundEffect> effects = knowledge_effects(o);
            result_.acting_.push_back(!effects.empty());
            if (result_.moment_ >= 0) effects.push_back({{result_.moment_, moments_[o]}, 0});
            result_.action_effects_.append(effects);
            const std::int64_t cost = physical_.costs[o] * kActionUnit;
            const auto name = physical_.operator_names.names[o];
            const std::vector<std::uint32_t> words(name.begin(), name.end());
            CompiledOperator origin;
            origin.action = static_cast<std::uint32_t>(o);
            if (result_.acting_[o] || moments_[o] > 0)
                add_operator(precondition, effects, cost, origin, words);
            CompiledOperator only_reads;
            only_reads.read_after = static_cast<std::uint32_t>(o);
            for (const GroundReading& reading : belief_.readings[o]) {
                if (!uncertain(reading.fact.variable)) continue;
                if (moments_[o] > 0)
                    add_readings({{result_.moment_, moments_[o]}}, {}, 1, only_reads, words, reading.fact);
                else
                    add_readings(precondition, effects, cost, origin, words, reading.fact);
            }
        }
    }

    void make_sensors() {
        for (std::size_t s = 0; s < belief_.sensors.size(); ++s) {
            const Fact read = belief_.sensors[s].reading.fact;
            if (!uncertain(read.variable)) continue;
            Condition precondition;
            for (const Fact& fact : belief_.sensor_conditions[s]) precondition.push_back(known(fact));
            CompiledOperator origin;
            origin.sensor = static_cast<std::uint32_t>(s);
            task_->operator_names.symbols.push_back(belief_.sensors[s].name);
            add_readings(precondition, {}, 1, origin,
                         {static_cast<std::uint32_t>(task_->operator_names.symbols.size() - 1)}, read);
        }
    }

    /// Groups of the physical task hold for knowledge, too: two facts that exclude each other are not both
    /// known.
    void add_mutex_groups() {
        for (std::size_t g = 0; g < physical_.mutex_groups.size(); ++g) {
            const auto group = physical_.mutex_groups[g];
            if (std::any_of(group.begin(), group.end(),
                            [&](const Fact& fact) { return uncertain(fact.variable); }))
                continue;
            for (const Fact& fact : group) task_->mutex_groups.add(known(fact));
            task_->mutex_groups.close();
        }
    }

    Compilation& result_;
    std::size_t most_slots_;
    const BeliefTask& belief_;
    const FiniteDomainTask& physical_;
    std::shared_ptr<FiniteDomainTask> task_;
    std::vector<bool> deduced_;          ///< by physical fact: knowledge of it is a derived variable
    std::vector<bool> changeable_;       ///< by physical variable: some action has an effect on it
    std::vector<std::int32_t> moments_;  ///< by operator: its value of the moment variable, or 0
    std::vector<std::vector<std::uint32_t>> guards_of_;  ///< by physical variable: guarded clauses
    std::set<Fact> needed_;                              ///< compiled facts that something asks for
    std::vector<bool> readable_;                         ///< by physical variable
    std::vector<std::vector<Reason>> reasons_;           ///< by physical fact: what it is deduced from
    std::vector<Fact> possible_;                         ///< by physical fact, of derived variables
    std::map<std::string, std::uint32_t> symbols_;
    std::map<Condition, std::uint32_t> conditions_;
    std::vector<std::vector<Fact>> neighbours_;          ///< by physical fact: implied by it
    std::vector<std::vector<std::uint32_t>> groups_of_;  ///< by physical fact
    std::vector<std::vector<Fact>> implied_;             ///< by physical fact
    std::vector<char> implied_done_;
};

Compilation::Compilation(std::shared_ptr<const BeliefTask> belief, std::size_t most_cases, std::size_t slots)
    : belief_(std::move(belief)), components_(find_components(*belief_, most_cases)) {
    Compiler(*this, slots).run();
}

}  // namespace praxis::belief
