#include "belief/compile/compiler.hpp"

#include <cmath>

namespace praxis::belief {

void Compiler::add_operator(const Condition& precondition, const std::vector<GroundEffect>& effects,
                            std::int64_t cost, CompiledOperator origin,
                            const std::vector<std::uint32_t>& words) {
    const auto sorted = conjunction(precondition);
    if (!sorted) return;
    task_->preconditions.append(*sorted);
    task_->effects.append(effects);
    task_->costs.push_back(static_cast<std::int32_t>(std::min<std::int64_t>(cost, 1 << 30)));
    task_->operator_names.names.append(words);
    result_.origins_.push_back(origin);
}

void Compiler::add_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
                            std::int64_t cost, CompiledOperator origin, std::vector<std::uint32_t> words,
                            Fact read) {
    if (tracked(read.variable)) return add_case_readings(precondition, effects, cost, origin, words, read);
    const std::int32_t basic = result_.variables_[index(read.variable)];
    for (const Fact& outcome : {read, opposite(read)}) {
        Condition needed = precondition;
        needed.push_back({basic, Compilation::kNotKnown});
        std::vector<GroundEffect> all = effects;
        for (const Fact& fact : implied(outcome))
            all.push_back({{result_.variables_[index(fact.variable)], fact.value}, 0});
        all.push_back({{basic, outcome.value}, 0});
        if (!result_.options_.all_readings &&
            std::none_of(all.begin(), all.end(),
                         [&](const GroundEffect& effect) { return needed_.contains(effect.fact); }))
            continue;
        origin.reads = true;
        origin.outcome = outcome;
        add_operator(needed, all, cost + risk_of(outcome), origin, words);
    }
}

void Compiler::add_case_readings(const Condition& precondition, const std::vector<GroundEffect>& effects,
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
        add_operator(needed, all, cost + risk_of(outcome), origin, words);
    }
}

std::int64_t Compiler::risk_of(Fact outcome) {
    if (result_.options_.risk == 0) return 0;
    const double unit = static_cast<double>(kActionUnit * physical_.cost_scale);
    return std::llround(result_.options_.risk * unit * -std::log(probability(outcome)));
}

double Compiler::probability(Fact fact) {
    constexpr double kLeast = 1e-6;
    if (tracked(fact.variable)) {
        const Component& component =
            result_.components_.tracked[result_.components_.component_of[index(fact.variable)]];
        const std::uint32_t column = result_.components_.column_of[index(fact.variable)];
        std::size_t holds = 0;
        for (std::size_t i = 0; i < component.count(); ++i)
            holds += component.cases[i * component.variables.size() + column] == fact.value;
        // Where all cases agree at first, it is an action that will part them.
        if (holds == 0 || holds == component.count()) return 0.5;
        return static_cast<double>(holds) / static_cast<double>(component.count());
    }
    if (neighbours_.empty()) index_implications();
    const auto smallest_group = [&](Fact member) {
        std::size_t size = 0;
        for (std::uint32_t group : groups_of_[number(member)])
            if (size == 0 || belief_.groups[group].size() < size) size = belief_.groups[group].size();
        return static_cast<double>(size);
    };
    if (const double size = smallest_group(fact); size > 0) return 1 / size;
    if (const double size = smallest_group(opposite(fact)); size > 0) return std::max(kLeast, 1 - 1 / size);
    return 0.5;
}

void Compiler::find_moments() {
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

void Compiler::find_needed() {
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

void Compiler::make_operators() {
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
        if (result_.acting_[o] || moments_[o] > 0) add_operator(precondition, effects, cost, origin, words);
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

void Compiler::make_sensors() {
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

void Compiler::add_mutex_groups() {
    for (std::size_t g = 0; g < physical_.mutex_groups.size(); ++g) {
        const auto group = physical_.mutex_groups[g];
        if (std::any_of(group.begin(), group.end(),
                        [&](const Fact& fact) { return uncertain(fact.variable); }))
            continue;
        for (const Fact& fact : group) task_->mutex_groups.add(known(fact));
        task_->mutex_groups.close();
    }
}

}  // namespace praxis::belief
