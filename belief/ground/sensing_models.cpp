#include "belief/ground/sensing_models.hpp"

#include <algorithm>
#include <utility>

namespace praxis::belief {
namespace {

Fact opposite(Fact fact) {
    return {fact.variable, 1 - fact.value};
}

/// Adds a variable of two values.
Fact add_variable(FiniteDomainTask& task, const std::vector<std::uint32_t>& words) {
    using Form = FiniteDomainTask::FactForm;
    task.domain_sizes.push_back(2);
    task.axiom_layers.push_back(-1);
    task.initial_values.push_back(1);
    task.first_fact.push_back(task.first_fact.back() + 2);
    for (const Form form : {Form::atom, Form::negated_atom}) {
        task.fact_names.names.append(words);
        task.fact_forms.push_back(words.empty() ? Form::none_of_those : form);
    }
    return {static_cast<std::int32_t>(task.domain_sizes.size()) - 1, 0};
}

/// Where a condition will hold after effects, of which the later ones win.
Dnf regressed(const Dnf& after, std::span<const GroundEffect> effects, const FiniteDomainTask& task) {
    Dnf result;
    for (const Dnf::Term& term : after.terms()) {
        Dnf all = Dnf::always();
        for (const Fact& fact : term) {
            Dnf holds = Dnf::of(fact);
            for (const GroundEffect& effect : effects) {
                if (effect.fact.variable != fact.variable) continue;
                const Dnf fires = Dnf::of(task.conditions[effect.condition]);
                holds = effect.fact == fact ? holds | fires : holds & negation(fires, task.domain_sizes);
            }
            all = all & holds;
        }
        result = result | all;
    }
    return result;
}

}  // namespace

SensingModels::SensingModels(std::shared_ptr<const ContingentTask> source,
                             std::shared_ptr<const FiniteDomainTask> ground, const Conditions& conditions)
    : source_(std::move(source)),
      ground_(std::move(ground)),
      conditions_(conditions),
      observables_(find_observables(*source_)),
      open_(conditions.open()) {}

const std::vector<SensingRule>& SensingModels::rules_of(std::size_t schema) const {
    return source_->sensing[schema].own_model ? source_->sensing[schema].model : source_->default_model;
}

void SensingModels::read(std::size_t schema, std::span<const ObjectId> arguments, const Context& after,
                         PackedLists<GroundReading>& readings) {
    const std::vector<SensingRule>& rules = rules_of(schema);
    if (rules.empty()) return;
    const bool own = source_->sensing[schema].own_model;
    const Scope& scope = own ? source_->task->schemas[schema].scope : source_->default_scope;
    std::vector<bool> stated_true(observables_.all.size(), false);
    for (const SensingRule& rule : rules)
        if (rule.value) stated_true[rule.predicate.index()] = true;
    std::map<Atom, Observed> observed;
    for (const SensingRule& rule : rules) {
        const std::size_t predicate = rule.predicate.index();
        // Where a model says what reads true, the rest reads false anyway.
        if (rule.value != stated_true[predicate]) continue;
        const Context& known = observables_.asked[predicate] ? open_ : after;
        Conditions::Binding binding = Conditions::bind(scope, own ? arguments : std::span<const ObjectId>());
        try {
            conditions_.instances(
                rule.variables, rule.condition, scope, binding, known, [&](const Conditions::Binding& full) {
                    Observed& sum = observed[{rule.predicate, Conditions::resolve(rule.terms, full)}];
                    sum.condition = sum.condition | conditions_.dnf(rule.condition, scope, full, known);
                    sum.value = rule.value;
                    sum.where = rule.where;
                });
        } catch (const DnfTooLarge&) {
            conditions_.refuse(rule.where, "a sensing model with too many cases");
        }
    }
    for (const auto& [atom, what] : observed) {
        if (observables_.asked[atom.first.index()])
            readings.add({asked(atom, what)});
        else if (!what.condition.is_never() && !what.condition.is_always())
            readings.add({defined(atom, what)});
    }
}

/// The fact that is read in place of an observable atom that is in no condition.
Fact SensingModels::defined(const Atom& atom, const Observed& observed) {
    const Dnf& condition = observed.condition;
    if (condition.terms().size() == 1 && condition.terms().begin()->size() == 1)
        return condition.terms().begin()->front();
    const auto [place, fresh] = defined_.try_emplace(condition);
    if (fresh) {
        place->second = {static_cast<std::int32_t>(ground_->variable_count() + fresh_.size()),
                         observed.value ? 0 : 1};
        definitions_.push_back({place->second, condition});
        fresh_.push_back(atom);
    }
    return place->second;
}

Fact SensingModels::asked(const Atom& atom, const Observed& observed) {
    const Place place = conditions_.place(atom.first, atom.second);
    const Fact holds = observed.value ? place.fact : opposite(place.fact);
    const auto [known, fresh] = asked_.try_emplace(atom, definitions_.size());
    if (fresh) {
        definitions_.push_back({holds, observed.condition});
    } else if (const GroundDefinition& definition = definitions_[known->second];
               definition.fact != holds || definition.condition != observed.condition) {
        conditions_.refuse(observed.where,
                           "an observable atom that conditions mention, but sensing models differ about it");
    }
    return place.fact;
}

/// Observable atoms that no model speaks of are false.
void SensingModels::define_the_rest() {
    std::set<std::int32_t> defined;
    for (const GroundDefinition& definition : definitions_) defined.insert(definition.fact.variable);
    std::set<std::string> asked;
    for (std::size_t p = 0; p < observables_.asked.size(); ++p)
        if (observables_.asked[p]) asked.insert(source_->task->predicates[p].name);
    for (std::size_t f = 0, v = 0; f < ground_->fact_count(); ++f) {
        while (ground_->first_fact[v + 1] <= f) ++v;
        const auto variable = static_cast<std::int32_t>(v);
        const auto words = ground_->fact_names.names[f];
        if (ground_->fact_forms[f] == FiniteDomainTask::FactForm::atom && !words.empty() &&
            asked.contains(ground_->fact_names.symbols[words[0]]) && !defined.contains(variable))
            definitions_.push_back({{variable, static_cast<std::int32_t>(f - ground_->first_fact[v])}, {}});
    }
}

void SensingModels::extend(FiniteDomainTask& physical) {
    define_the_rest();
    if (definitions_.empty()) return;
    for (const Atom& atom : fresh_) {
        std::vector<std::uint32_t> words{
            symbol(source_->task->predicates[atom.first.index()].name, physical)};
        for (ObjectId object : atom.second)
            words.push_back(symbol(source_->task->objects[object.index()].name, physical));
        add_variable(physical, words);
    }
    about_.resize(physical.variable_count());
    for (std::size_t d = 0; d < definitions_.size(); ++d)
        for (const Dnf::Term& term : definitions_[d].condition.terms())
            for (const Fact& fact : term) about_[index(fact.variable)].insert(d);
    PackedLists<GroundEffect> all;
    for (std::size_t o = 0; o < physical.operator_count(); ++o) {
        for (const GroundEffect& effect : physical.effects[o]) all.add(effect);
        for (const GroundEffect& effect : effects(o, physical)) all.add(effect);
        all.close();
    }
    physical.effects = std::move(all);
}

std::vector<GroundEffect> SensingModels::effects(std::size_t o, FiniteDomainTask& physical) {
    Context before(physical.variable_count(), kOpen);
    for (const Fact& fact : physical.preconditions[o]) before[index(fact.variable)] = fact.value;
    const auto own = physical.effects[o];
    std::set<std::size_t> touched;
    for (const GroundEffect& effect : own)
        touched.insert(about_[index(effect.fact.variable)].begin(),
                       about_[index(effect.fact.variable)].end());
    std::vector<GroundEffect> result;
    for (std::size_t d : touched) {
        const GroundDefinition& definition = definitions_[d];
        Dnf after;
        try {
            after = given(regressed(definition.condition, own, physical), before);
        } catch (const DnfTooLarge&) {
            conditions_.refuse(source_->task->goal.where,
                               physical.operator_name(OperatorId(o)) + " changes what " +
                                   physical.fact_name(definition.fact) + " shows in too many ways");
        }
        if (after == given(definition.condition, before)) continue;
        if (!after.is_always()) result.push_back({opposite(definition.fact), 0});
        for (const Dnf::Term& term : after.terms())
            result.push_back({definition.fact, condition(term, physical)});
    }
    return result;
}

std::uint32_t SensingModels::condition(const Dnf::Term& facts, FiniteDomainTask& physical) {
    if (facts.empty()) return 0;
    const auto [place, fresh] =
        made_conditions_.try_emplace(facts, static_cast<std::uint32_t>(physical.conditions.size()));
    if (fresh) physical.conditions.append(facts);
    return place->second;
}

void SensingModels::begin(BeliefTask& task, FiniteDomainTask& physical, bool always) {
    task.initial_values.resize(physical.variable_count(), BeliefTask::kUnknown);
    for (const GroundDefinition& definition : definitions_) {
        const Fact fact = definition.fact;
        const Dnf first = given(definition.condition, task.initial_values);
        if (first.is_never() || first.is_always()) {
            const Fact holding = first.is_always() ? fact : opposite(fact);
            task.initial_values[index(fact.variable)] = holding.value;
            physical.initial_values[index(fact.variable)] = holding.value;
        } else {
            equate(fact, first, false, task, physical);
        }
        if (always && first == definition.condition) equate(fact, first, true, task, physical);
    }
    task.definitions = definitions_;
}

/// Clauses that make a fact equal to a condition. Only facts alone are compared in all states.
void SensingModels::equate(Fact fact, const Dnf& condition, bool invariant, BeliefTask& task,
                           FiniteDomainTask& physical) {
    const bool simple = std::all_of(condition.terms().begin(), condition.terms().end(),
                                    [](const Dnf::Term& term) { return term.size() == 1; });
    if (invariant && !simple) return;
    std::vector<Fact> some{opposite(fact)};
    for (const Dnf::Term& term : condition.terms()) {
        const Fact cause = term.size() == 1 ? term.front() : helper(term, task, physical);
        some.push_back(cause);
        task.add_clause(std::vector<Fact>{opposite(cause), fact}, invariant);
    }
    task.add_clause(some, invariant);
}

/// A variable that says whether a conjunction holds at first.
Fact SensingModels::helper(const Dnf::Term& term, BeliefTask& task, FiniteDomainTask& physical) {
    const Fact all = add_variable(physical, {});
    task.initial_values.push_back(BeliefTask::kUnknown);
    task.first_definitions.push_back({all, Dnf::of(term)});
    std::vector<Fact> none{all};
    for (const Fact& fact : term) {
        task.add_clause(std::vector<Fact>{opposite(all), fact}, false);
        none.push_back(opposite(fact));
    }
    task.add_clause(none, false);
    return all;
}

std::set<std::int32_t> SensingModels::depending(const std::set<std::int32_t>& variables) const {
    std::set<std::int32_t> result;
    for (std::int32_t variable : variables)
        if (index(variable) < about_.size())
            for (std::size_t d : about_[index(variable)]) result.insert(definitions_[d].fact.variable);
    return result;
}

std::uint32_t SensingModels::symbol(const std::string& word, FiniteDomainTask& physical) {
    std::vector<std::string>& symbols = physical.fact_names.symbols;
    if (symbols_.empty())
        for (std::uint32_t i = 0; i < symbols.size(); ++i) symbols_.try_emplace(symbols[i], i);
    const auto [place, fresh] = symbols_.try_emplace(word, static_cast<std::uint32_t>(symbols.size()));
    if (fresh) symbols.push_back(word);
    return place->second;
}

}  // namespace praxis::belief
