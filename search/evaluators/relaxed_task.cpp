#include "search/evaluators/relaxed_task.hpp"

#include <algorithm>
#include <numeric>

#include "search/evaluators/operator_costs.hpp"
#include "search/evaluators/relaxed_rules.hpp"

namespace praxis {

RelaxedTask::RelaxedTask(const FiniteDomainTask& task, std::span<const Fact> goal_facts, CostType cost_type,
                         Dominance dominance)
    : first_fact(task.first_fact),
      operator_count(static_cast<std::uint32_t>(task.operator_count())),
      costs(operator_costs(task, cost_type)) {
    costs.push_back(0);
    const relaxed::Rules rules = relaxed::make_rules(task, goal_facts, kMaxPreconditions);
    const std::vector<std::uint32_t>& effects = rules.effects.items();
    std::vector<char> marks(effects.size());
    std::vector<std::uint32_t> proposition_of(rules.fact_count, kNone);
    {
        const relaxed::Achievers achievers(rules);
        const std::vector<char> relevant = relaxed::relevant_facts(rules, achievers);
        for (std::size_t i = 0; i < effects.size(); ++i) marks[i] = relevant[effects[i]];
        if (dominance == Dominance::drop) relaxed::unmark_dominated(rules, achievers, costs, marks);
        proposition_count = 1;
        for (std::uint32_t fact = 0; fact < rules.fact_count; ++fact) {
            if (relevant[fact]) proposition_of[fact] = proposition_count++;
        }
    }
    goal = proposition_of[rules.goal];
    fact_proposition.assign(proposition_of.begin(),
                            proposition_of.begin() + static_cast<std::ptrdiff_t>(task.fact_count()));

    users_begin.assign(proposition_count + 1, 0);
    std::vector<std::uint32_t> next(rules.size(), relaxed::kNoRule);
    if (dominance == Dominance::drop) next = relaxed::next_alike(rules, costs);
    std::vector<char> done(rules.size(), false);
    for (std::uint32_t first = 0; first < rules.size(); ++first) {
        if (done[first]) continue;
        const auto begin = static_cast<std::uint32_t>(records.size());
        records.insert(records.end(), {static_cast<std::uint32_t>(costs[rules.operators[first]]), 0});
        const std::size_t parts = operator_of.size();
        for (std::uint32_t i = first; i != relaxed::kNoRule; i = next[i]) {
            done[i] = true;
            const std::size_t before = records.size();
            for (std::uint32_t j = rules.effects.begin_of(i); const std::uint32_t effect : rules.effects[i]) {
                if (marks[j++]) records.push_back(proposition_of[effect]);
            }
            if (records.size() == before) continue;
            part_end.push_back(static_cast<std::uint32_t>(records.size()) - begin - 2);
            operator_of.push_back(rules.operators[i]);
            if (task.has_conditional_effects()) condition_of.push_back(rules.conditions[i]);
        }
        if (operator_of.size() == parts) {
            records.resize(begin);
            continue;
        }
        const std::span<const std::uint32_t> preconditions = rules.preconditions[first];
        const std::size_t precondition_count = std::max<std::size_t>(preconditions.size(), 1);
        if (rules.effects[first].front() == rules.goal) goal_rule = rule_count();
        record_begin.push_back(begin);
        records[begin + 1] = part_end.back() << 8 | static_cast<std::uint32_t>(precondition_count);
        if (preconditions.empty()) records.push_back(kTrue);
        for (const std::uint32_t fact : preconditions) records.push_back(proposition_of[fact]);
        precondition_counts.push_back(static_cast<std::uint8_t>(precondition_count));
        parts_begin.push_back(static_cast<std::uint32_t>(parts));
    }
    parts_begin.push_back(static_cast<std::uint32_t>(operator_of.size()));

    for (std::uint32_t i = 0; i < rule_count(); ++i) {
        for (const std::uint32_t proposition : rule(i).preconditions) ++users_begin[proposition];
    }
    std::exclusive_scan(users_begin.begin(), users_begin.end(), users_begin.begin(), 0u);
    users.resize(users_begin.back());
    std::vector<std::uint32_t> place(users_begin.begin(), users_begin.end() - 1);
    for (std::uint32_t i = 0; i < rule_count(); ++i) {
        for (const std::uint32_t proposition : rule(i).preconditions) users[place[proposition]++] = i;
    }
}

std::uint32_t RelaxedTask::part(std::uint32_t index, std::uint32_t effect) const {
    const std::span<const std::uint32_t> effects = rule(index).effects;
    const auto place = static_cast<std::uint32_t>(std::ranges::find(effects, effect) - effects.begin());
    const auto first = part_end.begin() + parts_begin[index];
    const auto last = part_end.begin() + parts_begin[index + 1];
    return static_cast<std::uint32_t>(std::upper_bound(first, last, place) - part_end.begin());
}

}  // namespace praxis
