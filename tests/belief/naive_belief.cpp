#include "tests/belief/naive_belief.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "belief/environment.hpp"
#include "belief/ground/observable_axioms.hpp"
#include "belief/ground/observables.hpp"

namespace praxis::belief::test {

using Tuple = praxis::test::NaiveSemantics::Tuple;

NaiveBelief::NaiveBelief(const BeliefTask& task)
    : task_(task),
      lifted_(with_observable_axioms(*task.source)),
      semantics_(lifted_),
      literals_(task.physical->fact_count()),
      represented_(semantics_.atom_count(), false) {
    const FiniteDomainTask& physical = *task.physical;
    std::map<std::string, std::size_t> atoms, schemas, objects;
    const Observables observables = find_observables(*task.source);
    std::vector<bool> no_state(semantics_.atom_count(), false);
    for (std::size_t p = 0; p < lifted_.predicates.size(); ++p)
        for (std::size_t a = semantics_.first()[p]; a < semantics_.first()[p + 1]; ++a)
            no_state[a] = observables.all[p] && !observables.asked[p];
    for (std::size_t a = 0; a < semantics_.atom_count(); ++a) atoms[semantics_.atom_name(a)] = a;
    for (std::size_t f = 0; f < literals_.size(); ++f) {
        const auto place = atoms.find(physical.fact_names.words(f));
        if (place == atoms.end() || physical.fact_forms[f] == FiniteDomainTask::FactForm::none_of_those ||
            no_state[place->second])
            continue;
        literals_[f] = Literal{place->second, physical.fact_forms[f] == FiniteDomainTask::FactForm::atom};
        represented_[place->second] = true;
    }
    for (std::size_t s = 0; s < lifted_.schemas.size(); ++s) schemas[lifted_.schemas[s].name] = s;
    for (std::size_t o = 0; o < lifted_.objects.size(); ++o) objects[lifted_.objects[o].name] = o;
    for (std::size_t o = 0; o < physical.operator_count(); ++o) {
        const auto words = physical.operator_names.names[o];
        GroundAction action{schemas.at(physical.operator_names.symbols[words[0]]), {}};
        for (std::uint32_t word : words.subspan(1))
            action.arguments.push_back(
                static_cast<std::uint32_t>(objects.at(physical.operator_names.symbols[word])));
        actions_.push_back(std::move(action));
    }

    std::set<std::size_t> open;
    const ContingentTask& source = *task.source;
    for (const GroundLiteral& literal : source.unknown) open.insert(atom(literal));
    for (const Clause& clause : source.clauses)
        for (const GroundLiteral& literal : clause.literals) open.insert(atom(literal));
    for (const MultiValuedVariable& variable : source.variables)
        if (!variable.observable && !decided(variable))
            for (const GroundLiteral& value : variable.values) open.insert(atom(value));
    for (std::size_t p = 0; p < lifted_.predicates.size(); ++p)
        if (source.open_world[p])
            for (std::size_t a = semantics_.first()[p]; a < semantics_.first()[p + 1]; ++a) open.insert(a);
    for (const GroundLiteral& literal : source.known_false) open.erase(atom(literal));
    const State certain = semantics_.initial();
    for (std::size_t a : open)
        if (!certain[a]) uncertain_.push_back(a);
}

std::size_t NaiveBelief::atom(const GroundLiteral& literal) const {
    Tuple arguments;
    for (ObjectId object : literal.arguments) arguments.push_back(object.index());
    return semantics_.atom(literal.predicate, arguments);
}

bool NaiveBelief::allowed(const State& state) const {
    for (const Clause& clause : task_.source->clauses) {
        std::size_t holding = 0;
        for (const GroundLiteral& literal : clause.literals)
            holding += state[atom(literal)] != literal.negated;
        if (clause.kind != ClauseKind::at_most_one && holding == 0) return false;
        if (clause.kind != ClauseKind::at_least_one && holding > 1) return false;
    }
    for (const MultiValuedVariable& variable : task_.source->variables)
        if (!variable.observable && variable.values.size() > 1 && values_holding(variable, state) != 1)
            return false;
    return true;
}

bool NaiveBelief::decided(const MultiValuedVariable& variable) const {
    return values_holding(variable, semantics_.initial()) > 0;
}

std::size_t NaiveBelief::values_holding(const MultiValuedVariable& variable, const State& state) const {
    std::size_t holding = 0;
    for (const GroundLiteral& value : variable.values) holding += state[atom(value)];
    return holding;
}

std::set<NaiveBelief::State> NaiveBelief::opened(std::size_t open, State state) const {
    std::set<State> result;
    for (const MultiValuedVariable& variable : task_.source->variables) {
        std::vector<std::size_t> values;
        for (const GroundLiteral& value : variable.values) values.push_back(atom(value));
        if (values.size() < 2 || std::find(values.begin(), values.end(), open) == values.end()) continue;
        for (std::size_t chosen : values) {
            for (std::size_t value : values) state[value] = value == chosen;
            semantics_.close(state);
            result.insert(state);
        }
        return result;
    }
    for (const bool value : {false, true}) {
        state[open] = value;
        semantics_.close(state);
        result.insert(state);
    }
    return result;
}

std::vector<NaiveBelief::State> NaiveBelief::first_states() const {
    std::vector<State> result;
    for (std::size_t choice = 0; choice < std::size_t{1} << uncertain_.size(); ++choice) {
        State state = semantics_.initial();
        for (std::size_t i = 0; i < uncertain_.size(); ++i) state[uncertain_[i]] = (choice >> i & 1) != 0;
        if (!allowed(state)) continue;
        semantics_.close(state);
        result.push_back(std::move(state));
    }
    return result;
}

bool NaiveBelief::applicable(std::uint32_t action, const State& state) const {
    return semantics_.applicable(lifted_.schemas[actions_[action].schema], actions_[action].arguments, state);
}

template <class Visit>
void NaiveBelief::bindings(const std::vector<std::uint32_t>& variables, const Scope& scope, Tuple& values,
                           std::size_t next, const Visit& visit) const {
    if (next == variables.size()) return visit();
    const std::uint32_t variable = variables[next];
    for (ObjectId object : lifted_.types[scope.variable_types[variable].index()].objects) {
        values[variable] = object.index();
        bindings(variables, scope, values, next + 1, visit);
    }
}

template <class Described, class Visit>
void NaiveBelief::atoms(const Described& described, const Scope& scope, const Tuple& arguments,
                        const State& state, const Visit& visit) const {
    Tuple values(scope.variable_types.size());
    std::copy(arguments.begin(), arguments.end(), values.begin());
    bindings(described.variables, scope, values, 0, [&] {
        if (!semantics_.holds(described.condition, scope, values, state)) return;
        Tuple objects;
        for (const Term& term : described.terms)
            objects.push_back(term.is_variable() ? values[term.variable_index()] : term.object_id().index());
        visit(semantics_.atom(described.predicate, objects));
    });
}

std::vector<NaiveBelief::State> NaiveBelief::successors(std::uint32_t action, const State& state) const {
    const auto& [schema, arguments] = actions_[action];
    const Schema& description = lifted_.schemas[schema];
    std::set<State> result{semantics_.successor(description, arguments, state)};
    for (const Effect& effect : task_.source->sensing[schema].forgotten)
        atoms(effect, description.scope, arguments, state, [&](std::size_t open) {
            std::set<State> more;
            for (const State& next : result) more.merge(opened(open, next));
            result = std::move(more);
        });
    return {result.begin(), result.end()};
}

std::vector<NaiveBelief::Literal> NaiveBelief::readings(std::uint32_t action, const State& state) const {
    std::set<Literal> result;
    const auto add = [&](std::size_t atom) { result.insert({atom, state[atom]}); };
    if (action != Environment::kStart) {
        const auto& [schema, arguments] = actions_[action];
        for (const Observation& observation : task_.source->sensing[schema].observations)
            atoms(observation, lifted_.schemas[schema].scope, arguments, state, add);
    }
    for (const Sensor& sensor : task_.source->sensors)
        semantics_.instances(sensor.scope, [&](const Tuple& arguments) {
            Tuple values(sensor.scope.variable_types.size());
            std::copy(arguments.begin(), arguments.end(), values.begin());
            if (!semantics_.holds(sensor.condition, sensor.scope, values, state)) return;
            for (const Observation& observation : sensor.observations)
                atoms(observation, sensor.scope, arguments, state, add);
        });
    return {result.begin(), result.end()};
}

std::vector<NaiveBelief::Literal> NaiveBelief::model_readings(std::uint32_t action,
                                                              const State& state) const {
    if (action == Environment::kStart) return {};
    const auto& [schema, arguments] = actions_[action];
    const ContingentTask& source = *task_.source;
    const bool own = source.sensing[schema].own_model;
    const std::vector<SensingRule>& rules = own ? source.sensing[schema].model : source.default_model;
    const Scope& scope = own ? lifted_.schemas[schema].scope : source.default_scope;
    std::set<std::uint32_t> stated_true;
    for (const SensingRule& rule : rules)
        if (rule.value) stated_true.insert(rule.predicate.index());
    std::map<std::size_t, bool> result;
    for (const SensingRule& rule : rules) {
        const bool positive = stated_true.contains(rule.predicate.index());
        if (rule.value != positive) continue;
        Formula always;
        const SensingRule mention{rule.variables, always, true, rule.predicate, rule.terms, rule.where};
        atoms(mention, scope, own ? arguments : Tuple{}, state,
              [&](std::size_t atom) { result.try_emplace(atom, !positive); });
        atoms(rule, scope, own ? arguments : Tuple{}, state,
              [&](std::size_t atom) { result[atom] = positive; });
    }
    return {result.begin(), result.end()};
}

NaiveBelief::State NaiveBelief::of(const WorldState& state) const {
    State result = semantics_.initial();
    for (std::size_t v = 0; v < state.size(); ++v)
        for (std::int32_t value = 0; value < task_.physical->domain_sizes[v]; ++value)
            if (const auto said = literal({static_cast<std::int32_t>(v), value}); said && said->second)
                result[said->first] = value == state[v];
    semantics_.close(result);
    return result;
}

}  // namespace praxis::belief::test
