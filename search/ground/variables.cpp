#include "search/ground/variables.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace praxis::grounding {
namespace {

/// Repeatedly takes the group with most uncovered atoms, until only single atoms are left.
class Cover {
  public:
    Cover(const PropositionTask& task, const PackedLists<AtomId>& groups, Variables& variables)
        : task_(task), groups_(groups), variables_(variables) {}

    void run() {
        variables_.fact_of.assign(task_.atom_count, Fact{Variables::kNone, 0});
        std::vector<std::uint32_t> uncovered(groups_.size());
        std::vector<std::vector<std::uint32_t>> by_size;
        std::vector<std::uint32_t> count(task_.atom_count + 1, 0);
        for (AtomId atom : groups_.items()) ++count[atom + 1];
        for (std::size_t i = 1; i < count.size(); ++i) count[i] += count[i - 1];
        std::vector<std::uint32_t> groups_of(groups_.total());
        std::vector<std::uint32_t> fill(count.begin(), count.end() - 1);
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            for (AtomId atom : groups_[g]) groups_of[fill[atom]++] = static_cast<std::uint32_t>(g);
            uncovered[g] = static_cast<std::uint32_t>(groups_[g].size());
        }
        for (std::uint32_t group : by_overlap(count)) {
            by_size.resize(std::max<std::size_t>(by_size.size(), uncovered[group] + 1));
            by_size[uncovered[group]].push_back(group);
        }
        std::vector<AtomId> members;
        for (std::size_t size = by_size.size(); size-- > 2;) {
            for (std::size_t i = 0; i < by_size[size].size(); ++i) {
                const std::uint32_t group = by_size[size][i];
                if (uncovered[group] != size) {
                    if (uncovered[group] > 1) by_size[uncovered[group]].push_back(group);
                    continue;
                }
                members.clear();
                for (AtomId atom : groups_[group]) {
                    if (variables_.fact_of[atom].variable != Variables::kNone) continue;
                    members.push_back(atom);
                    for (std::uint32_t k = count[atom]; k < count[atom + 1]; ++k) --uncovered[groups_of[k]];
                }
                add_variable(members, false);
            }
        }
        for (AtomId atom = 0; atom < task_.atom_count; ++atom)
            if (!task_.constant[atom] && !task_.never[atom] &&
                variables_.fact_of[atom].variable == Variables::kNone)
                add_variable({&atom, 1}, true);
    }

  private:
    /// Groups whose atoms are in few other groups first: taking one then breaks few others.
    std::vector<std::uint32_t> by_overlap(const std::vector<std::uint32_t>& groups_before) const {
        std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
        for (std::uint32_t g = 0; g < groups_.size(); ++g) {
            std::uint64_t overlap = 0;
            for (AtomId atom : groups_[g]) overlap += groups_before[atom + 1] - groups_before[atom];
            order.emplace_back(overlap, g);
        }
        std::sort(order.begin(), order.end());
        std::vector<std::uint32_t> result;
        for (const auto& [overlap, group] : order) result.push_back(group);
        return result;
    }

    void add_variable(std::span<const AtomId> members, bool has_none) {
        const auto variable = static_cast<std::int32_t>(variables_.count());
        for (std::size_t value = 0; value < members.size(); ++value)
            variables_.fact_of[members[value]] = {variable, static_cast<std::int32_t>(value)};
        variables_.members.append(members);
        variables_.has_none.push_back(has_none);
        variables_.is_shadow.push_back(false);
    }

    const PropositionTask& task_;
    const PackedLists<AtomId>& groups_;
    Variables& variables_;
};

/// Marks the variables that can lose their value without getting another.
void find_none_values(const PropositionTask& task, Variables& variables) {
    std::vector<bool> held(variables.count(), false);
    for (AtomId atom = 0; atom < task.atom_count; ++atom)
        if (task.initial[atom] && !task.constant[atom])
            held[static_cast<std::size_t>(variables.fact_of[atom].variable)] = true;
    for (std::size_t v = 0; v < variables.count(); ++v)
        if (!held[v]) variables.has_none[v] = true;
    for (std::size_t o = 0; o < task.operator_count(); ++o) {
        for (const PropositionEffect& effect : task.effects[o]) {
            if (!is_negative(effect.literal)) continue;
            const std::int32_t variable = variables.fact_of[atom_of(effect.literal)].variable;
            if (variables.has_none[static_cast<std::size_t>(variable)] ||
                overridden(task, variables, o, effect))
                continue;
            const auto precondition = task.preconditions[o];
            const bool elsewhere =
                std::any_of(precondition.begin(), precondition.end(), [&](Literal literal) {
                    return !is_negative(literal) && literal != positive(atom_of(effect.literal)) &&
                           variables.fact_of[atom_of(literal)].variable == variable;
                });
            if (!elsewhere) variables.has_none[static_cast<std::size_t>(variable)] = true;
        }
    }
}

void add_shadows(const PropositionTask& task, Variables& variables) {
    variables.shadow_of.assign(task.atom_count, Variables::kNone);
    std::vector<bool> needed(task.atom_count, false);
    const auto look = [&](std::span<const Literal> literals) {
        for (Literal literal : literals) {
            if (!is_negative(literal)) continue;
            const AtomId atom = atom_of(literal);
            const std::int32_t variable = variables.fact_of[atom].variable;
            if (variables.size_of(static_cast<std::size_t>(variable)) <= 2) continue;
            const bool implied = std::any_of(literals.begin(), literals.end(), [&](Literal other) {
                return !is_negative(other) && variables.fact_of[atom_of(other)].variable == variable;
            });
            if (!implied) needed[atom] = true;
        }
    };
    for (std::size_t o = 0; o < task.operator_count(); ++o) look(task.preconditions[o]);
    for (std::size_t c = 0; c < task.conditions.size(); ++c) look(task.conditions[c]);
    for (std::size_t a = 0; a < task.heads.size(); ++a) look(task.bodies[a]);
    look(task.goal);
    for (AtomId atom = 0; atom < task.atom_count; ++atom) {
        if (!needed[atom]) continue;
        variables.shadow_of[atom] = static_cast<std::int32_t>(variables.count());
        variables.members.append(std::span<const AtomId>(&atom, 1));
        variables.has_none.push_back(true);
        variables.is_shadow.push_back(true);
    }
}

}  // namespace

bool overridden(const PropositionTask& task, const Variables& variables, std::size_t o,
                PropositionEffect deletion) {
    const std::int32_t variable = variables.fact_of[atom_of(deletion.literal)].variable;
    const auto precondition = task.preconditions[o];
    const auto given = task.conditions[deletion.condition];
    for (const PropositionEffect& effect : task.effects[o]) {
        if (is_negative(effect.literal) || variables.fact_of[atom_of(effect.literal)].variable != variable)
            continue;
        const auto wanted = task.conditions[effect.condition];
        if (std::all_of(wanted.begin(), wanted.end(), [&](Literal literal) {
                return std::binary_search(given.begin(), given.end(), literal) ||
                       std::binary_search(precondition.begin(), precondition.end(), literal);
            }))
            return true;
    }
    return false;
}

Variables choose_variables(const PropositionTask& task, const PackedLists<AtomId>& groups) {
    Variables variables;
    Cover(task, groups, variables).run();
    find_none_values(task, variables);
    add_shadows(task, variables);
    return variables;
}

}  // namespace praxis::grounding
