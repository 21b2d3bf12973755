#include "search/h2/mutex_pairs.hpp"

#include <algorithm>
#include <utility>

namespace praxis {

namespace {

std::vector<std::uint32_t> variables_of_facts(const FiniteDomainTask& task) {
    std::vector<std::uint32_t> variables;
    for (std::uint32_t v = 0; v < task.variable_count(); ++v) variables.resize(task.first_fact[v + 1], v);
    return variables;
}

bool conditional(const FiniteDomainTask& task, std::size_t op) {
    return std::ranges::any_of(task.effects[op], [](const GroundEffect& e) { return e.condition != 0; });
}

}  // namespace

MutexPairs::MutexPairs(const FiniteDomainTask& task)
    : task_(task),
      values_(task),
      pairs_(task.fact_count()),
      operator_possible_(task.operator_count(), true),
      effect_possible_(task.effects.total(), true),
      variable_of_(variables_of_facts(task)),
      can_go_backward_(!task.has_axioms()) {
    for (std::size_t v = 0; v < task.variable_count(); ++v) {
        if (task.axiom_layers[v] >= 0) can_go_backward_ = false;
    }
    for (std::size_t op = 0; op < task.operator_count(); ++op) {
        if (conditional(task, op)) can_go_backward_ = false;
    }
    FactBits facts(pairs_.words(), 0);
    for (std::uint32_t fact = 0; fact < task.fact_count(); ++fact) {
        if (task.axiom_layers[variable_of_[fact]] < 0) insert(facts, fact);
    }
    for (std::uint32_t fact = 0; fact < task.fact_count(); ++fact) {
        const std::uint32_t variable = variable_of_[fact];
        if (task.axiom_layers[variable] >= 0) continue;
        const std::span<std::uint64_t> row = pairs_.row(fact);
        std::ranges::copy(facts, row.begin());
        erase_range(row, task.first_fact[variable], task.first_fact[variable + 1]);
        insert(row, fact);
    }
    for (std::size_t group = 0; group < task.mutex_groups.size(); ++group) {
        FactBits members(pairs_.words(), 0);
        for (const std::uint32_t fact : numbers(task.mutex_groups[group])) insert(members, fact);
        for (const std::uint32_t fact : numbers(task.mutex_groups[group])) {
            const std::span<std::uint64_t> row = pairs_.row(fact);
            for (std::size_t word = 0; word < row.size(); ++word) row[word] &= ~members[word];
            insert(row, fact);
        }
    }
}

std::size_t MutexPairs::bytes(const FiniteDomainTask& task) {
    const std::size_t facts = task.fact_count();
    return 2 * facts * ((facts + 63) / 64) * sizeof(std::uint64_t);
}

// Derived variables are left out.
std::vector<std::uint32_t> MutexPairs::numbers(std::span<const Fact> facts) const {
    std::vector<std::uint32_t> result;
    for (const Fact fact : facts) {
        if (!task_.derived(fact.variable)) result.push_back(task_.fact_number(fact));
    }
    return result;
}

// What the operator sets without condition; of several effects on one variable the last.
std::vector<std::uint32_t> MutexPairs::unconditional(std::size_t op) const {
    std::vector<std::uint32_t> facts;
    for (const GroundEffect& effect : task_.effects[op]) {
        if (effect.condition != 0) continue;
        const auto variable = static_cast<std::uint32_t>(effect.fact.variable);
        std::erase_if(facts, [&](std::uint32_t fact) { return variable_of_[fact] == variable; });
        facts.push_back(task_.fact_number(effect.fact));
    }
    return facts;
}

bool MutexPairs::possible(std::span<const Fact> facts) const {
    for (std::size_t i = 0; i < facts.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            if (mutex(facts[i], facts[j])) return false;
        }
    }
    return true;
}

std::size_t MutexPairs::possible_count() const {
    return static_cast<std::size_t>(std::ranges::count(operator_possible_, true) +
                                    std::ranges::count(effect_possible_, true));
}

// For each possible operator a step of its unconditional effects, then one for each effect with a condition.
PairSteps MutexPairs::forward_steps() const {
    PairSteps steps;
    for (std::size_t op = 0; op < task_.operator_count(); ++op) {
        if (!operator_possible_[op]) continue;
        const std::vector<std::uint32_t> needs = numbers(task_.preconditions[op]);
        const std::vector<std::uint32_t> sets = unconditional(op);
        steps.needs.append(needs);
        for (const std::uint32_t fact : sets) steps.changes.add(variable_of_[fact]);
        steps.changes.close();
        steps.adds.append(sets);
        if (!conditional(task_, op)) {
            for (const std::uint32_t fact : sets) steps.surely.add(fact);
            for (const std::uint32_t fact : needs) {
                const auto same = [&](std::uint32_t other) {
                    return variable_of_[other] == variable_of_[fact];
                };
                if (std::ranges::none_of(sets, same)) steps.surely.add(fact);
            }
        }
        steps.surely.close();
        steps.companions.push_back({});
        const auto first = static_cast<std::uint32_t>(steps.size());
        for (std::uint32_t i = 0; i < task_.effects[op].size(); ++i) {
            const GroundEffect& effect = task_.effects[op][i];
            if (effect.condition == 0 || !effect_possible_[task_.effects.begin_of(op) + i]) continue;
            std::vector<std::uint32_t> all = numbers(task_.conditions[effect.condition]);
            all.insert(all.end(), needs.begin(), needs.end());
            std::ranges::sort(all);
            all.erase(std::unique(all.begin(), all.end()), all.end());
            steps.needs.append(all);
            const auto variable = static_cast<std::uint32_t>(effect.fact.variable);
            steps.changes.add(variable);
            steps.adds.add(task_.fact_number(effect.fact));
            for (const std::uint32_t fact : sets) {
                if (variable_of_[fact] == variable) continue;
                steps.changes.add(variable_of_[fact]);
                steps.adds.add(fact);
            }
            steps.changes.close();
            steps.adds.close();
            steps.surely.close();
            steps.companions.push_back({});
        }
        const auto last = static_cast<std::uint32_t>(steps.size());
        for (std::uint32_t step = first; step < last; ++step) steps.companions[step] = {first, last};
    }
    return steps;
}

// Each possible operator from what holds after it to what held before.
PairSteps MutexPairs::backward_steps() const {
    PairSteps steps;
    for (std::size_t op = 0; op < task_.operator_count(); ++op) {
        if (!operator_possible_[op]) continue;
        const std::vector<std::uint32_t> before = numbers(task_.preconditions[op]);
        for (const std::uint32_t fact : unconditional(op)) {
            const std::uint32_t variable = variable_of_[fact];
            steps.needs.add(fact);
            steps.changes.add(variable);
            const auto same = [&](std::uint32_t other) { return variable_of_[other] == variable; };
            const auto known = std::ranges::find_if(before, same);
            if (known != before.end()) {
                steps.adds.add(*known);
                continue;
            }
            for (std::uint32_t value = task_.first_fact[variable]; value < task_.first_fact[variable + 1];
                 ++value) {
                steps.adds.add(value);
            }
        }
        steps.changes.close();
        for (const std::uint32_t fact : before) {
            const auto same = [&](const GroundEffect& effect) {
                return static_cast<std::uint32_t>(effect.fact.variable) == variable_of_[fact];
            };
            if (std::ranges::none_of(task_.effects[op], same)) steps.needs.add(fact);
        }
        steps.needs.close();
        steps.adds.close();
        steps.surely.append(before);
        steps.companions.push_back({});
    }
    return steps;
}

void MutexPairs::learn(PairReachability& analysis, bool backward) {
    std::uint32_t step = 0;
    for (std::size_t op = 0; op < task_.operator_count(); ++op) {
        if (!operator_possible_[op]) continue;
        operator_possible_[op] = analysis.possible(step++);
        for (std::uint32_t i = 0; i < task_.effects[op].size(); ++i) {
            const std::size_t place = task_.effects.begin_of(op) + i;
            if (!backward && task_.effects[op][i].condition != 0 && effect_possible_[place]) {
                effect_possible_[place] = analysis.possible(step++);
            }
            if (!operator_possible_[op]) effect_possible_[place] = false;
        }
    }
    pairs_ = std::move(analysis.reached());
}

bool MutexPairs::forward(const Budget& budget) {
    std::vector<std::uint32_t> initial;
    for (std::size_t v = 0; v < task_.variable_count(); ++v) {
        if (task_.axiom_layers[v] >= 0) continue;
        initial.push_back(task_.first_fact[v] + static_cast<std::uint32_t>(task_.initial_values[v]));
    }
    if (!pairs_.test_all(initial)) unsolvable_ = true;
    if (unsolvable_) return true;
    PairMatrix reached(task_.fact_count());
    for (const std::uint32_t a : initial) {
        for (const std::uint32_t b : initial) reached.set(a, b);
    }
    const PairSteps steps = forward_steps();
    PairReachability analysis(task_, values_, steps, pairs_, std::move(reached));
    if (!analysis.run(budget)) return false;
    learn(analysis, false);
    FactBits goal;
    if (!goal_facts(goal)) unsolvable_ = true;
    return true;
}

// The facts that may hold together with the goal: a variable with a single value left is part of the goal.
// False if there can be no such state.
bool MutexPairs::goal_facts(FactBits& facts) const {
    facts.assign(pairs_.words(), 0);
    for (std::uint32_t fact = 0; fact < pairs_.facts(); ++fact) {
        if (pairs_.test(fact, fact)) insert(facts, fact);
    }
    std::vector<std::uint32_t> known = numbers(task_.goal);
    std::vector<bool> done(task_.variable_count(), false);
    while (!known.empty()) {
        for (const std::uint32_t fact : known) {
            intersect(facts, pairs_.row(fact));
            done[variable_of_[fact]] = true;
        }
        if (!contains_all(facts, known)) return false;
        known.clear();
        for (std::size_t v = 0; v < task_.variable_count(); ++v) {
            const std::uint32_t first = task_.first_fact[v];
            const std::uint32_t last = task_.first_fact[v + 1];
            if (done[v] || task_.axiom_layers[v] >= 0 || count_range(facts, first, last) != 1) continue;
            for (std::uint32_t fact = first; fact < last; ++fact) {
                if (contains(facts, fact)) known.push_back(fact);
            }
        }
    }
    return values_.every_variable_has_a_value(facts);
}

bool MutexPairs::backward(const Budget& budget) {
    FactBits goal;
    if (!goal_facts(goal)) unsolvable_ = true;
    if (unsolvable_) return true;
    PairMatrix reached(task_.fact_count());
    for (std::uint32_t fact = 0; fact < task_.fact_count(); ++fact) {
        if (!contains(goal, fact)) continue;
        const std::span<std::uint64_t> row = reached.row(fact);
        std::ranges::copy(pairs_.row(fact), row.begin());
        intersect(row, goal);
    }
    const PairSteps steps = backward_steps();
    PairReachability analysis(task_, values_, steps, pairs_, std::move(reached));
    if (!analysis.run(budget)) return false;
    learn(analysis, true);
    for (std::size_t v = 0; v < task_.variable_count() && !unsolvable_; ++v) {
        const Fact a{static_cast<std::int32_t>(v), task_.initial_values[v]};
        for (std::size_t w = 0; w <= v; ++w) {
            if (mutex(a, {static_cast<std::int32_t>(w), task_.initial_values[w]})) unsolvable_ = true;
        }
    }
    return true;
}

}  // namespace praxis
