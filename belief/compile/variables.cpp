#include "belief/compile/compiler.hpp"

namespace praxis::belief {

Fact Compiler::known(Fact fact) {
    Fact& place = result_.known_[number(fact)];
    if (tracked(fact.variable) && place.variable < 0) place = known_in_all_cases(fact);
    return place;
}

Fact Compiler::possible(Fact fact) {
    if (!uncertain(fact.variable)) return known(fact);
    if (tracked(fact.variable)) return possible_in_some_case(fact);
    if (physical_.derived(fact.variable)) return possible_[number(fact)];
    return {known(opposite(fact)).variable, 1};
}

std::int32_t Compiler::add_variable(std::int32_t size, std::int32_t layer, std::int32_t initial) {
    task_->domain_sizes.push_back(size);
    task_->axiom_layers.push_back(layer);
    task_->initial_values.push_back(initial);
    return static_cast<std::int32_t>(task_->domain_sizes.size()) - 1;
}

std::uint32_t Compiler::symbol(const std::string& word) {
    const auto [place, fresh] =
        symbols_.emplace(word, static_cast<std::uint32_t>(task_->fact_names.symbols.size()));
    if (fresh) task_->fact_names.symbols.push_back(word);
    return place->second;
}

void Compiler::name(const char* prefix, std::optional<Fact> fact) {
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

void Compiler::make_variables() {
    result_.known_.assign(physical_.fact_count(), {-1, 0});
    possible_.assign(physical_.fact_count(), {-1, 0});
    result_.variables_.assign(physical_.variable_count(), -1);
    for (std::size_t v = 0; v < physical_.variable_count(); ++v) make_variable(static_cast<std::int32_t>(v));
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

void Compiler::number_facts() {
    task_->first_fact = {0};
    for (std::int32_t size : task_->domain_sizes)
        task_->first_fact.push_back(task_->first_fact.back() + static_cast<std::uint32_t>(size));
}

void Compiler::make_slots() {
    for (const Component& component : result_.components_.tracked) {
        CompiledComponent compiled;
        for (std::size_t slot = 0; slot < std::min(component.count(), result_.options_.slots); ++slot) {
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

const CompiledComponent& Compiler::slots_of(std::int32_t variable) const {
    return result_.slots_[result_.components_.component_of[index(variable)]];
}

Fact Compiler::in_slot(Fact fact, std::size_t slot) const {
    return {slots_of(fact.variable).values[slot][result_.components_.column_of[index(fact.variable)]],
            fact.value};
}

Fact Compiler::add_derived(const char* prefix, Fact fact) {
    const std::int32_t derived = add_variable(2, 0, 1);
    name(prefix, fact);
    name("", std::nullopt);
    return {derived, 0};
}

Fact Compiler::known_in_all_cases(Fact fact) {
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

Fact Compiler::possible_in_some_case(Fact fact) {
    Fact& place = possible_[number(fact)];
    if (place.variable >= 0) return place;
    place = add_derived("possible", fact);
    const CompiledComponent& slots = slots_of(fact.variable);
    for (std::size_t slot = 0; slot < slots.possible.size(); ++slot)
        add_axiom(place, {{slots.possible[slot], 1}, in_slot(fact, slot)});
    return place;
}

void Compiler::make_variable(std::int32_t v) {
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

}  // namespace praxis::belief
