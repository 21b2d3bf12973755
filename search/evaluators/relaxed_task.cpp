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
    for (std::uint32_t i = 0; i < rules.size(); ++i) {
        const std::uint32_t first = rules.effects.begin_of(i);
        const auto count = static_cast<std::uint32_t>(rules.effects[i].size());
        const auto left = static_cast<std::uint32_t>(
            std::count(marks.begin() + first, marks.begin() + first + count, char{true}));
        if (left == 0) continue;
        const std::span<const std::uint32_t> preconditions = rules.preconditions[i];
        const std::size_t precondition_count = std::max<std::size_t>(preconditions.size(), 1);
        if (rules.effects[i].front() == rules.goal) goal_rule = rule_count();
        record_begin.push_back(static_cast<std::uint32_t>(records.size()));
        records.push_back(static_cast<std::uint32_t>(costs[rules.operators[i]]));
        records.push_back(left);
        records.push_back(static_cast<std::uint32_t>(precondition_count));
        for (std::uint32_t j = first; j < first + count; ++j) {
            if (marks[j]) records.push_back(proposition_of[effects[j]]);
        }
        if (preconditions.empty()) records.push_back(kTrue);
        for (const std::uint32_t fact : preconditions) records.push_back(proposition_of[fact]);
        precondition_counts.push_back(static_cast<std::uint8_t>(precondition_count));
        operator_of.push_back(rules.operators[i]);
        condition_of.push_back(rules.conditions[i]);
    }

    for (std::uint32_t i = 0; i < rule_count(); ++i) {
        for (const std::uint32_t proposition : rule(i).preconditions) ++users_begin[proposition];
    }
    std::exclusive_scan(users_begin.begin(), users_begin.end(), users_begin.begin(), 0u);
    users.resize(users_begin.back());
    std::vector<std::uint32_t> next(users_begin.begin(), users_begin.end() - 1);
    for (std::uint32_t i = 0; i < rule_count(); ++i) {
        for (const std::uint32_t proposition : rule(i).preconditions) users[next[proposition]++] = i;
    }
}

}  // namespace praxis
