// Rules under construction: the delete relaxation over fact numbers, before RelaxedTask packs it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/task/finite_domain_task.hpp"
#include "search/task/packed_lists.hpp"

namespace praxis::relaxed {

/// Relaxed facts: a fact's number; from fact_count on, made-up ones.
struct Rules {
    PackedLists<std::uint32_t> preconditions;  ///< by rule; sorted, without repetition
    PackedLists<std::uint32_t> effects;     ///< by rule; sorted, without repetition and without preconditions
    std::vector<std::uint32_t> operators;   ///< by rule; operator_count: no operator's
    std::vector<std::uint32_t> conditions;  ///< by rule: number of the effect condition
    std::uint32_t fact_count = 0;           ///< made-up ones included
    std::uint32_t goal = 0;                 ///< the made-up fact that the last rule reaches from all goals

    std::size_t size() const { return operators.size(); }
};

/// All operators, axioms, default values and the goal as rules. `max_preconditions` as in RelaxedTask.
Rules make_rules(const FiniteDomainTask& task, std::span<const Fact> goal, std::size_t max_preconditions);

/// Which effects of which rules there are, by the fact they reach.
struct Achievers {
    struct Entry {
        std::uint32_t rule;
        std::uint32_t effect;  ///< place in Rules::effects.items()
    };
    std::vector<std::uint32_t> begin;  ///< by fact
    std::vector<Entry> entries;

    explicit Achievers(const Rules& rules);
    std::span<const Entry> of(std::uint32_t fact) const {
        return {entries.data() + begin[fact], entries.data() + begin[fact + 1]};
    }
};

/// By fact: whether it can matter for the goal.
std::vector<char> relevant_facts(const Rules& rules, const Achievers& achievers);

inline constexpr std::uint32_t kNoRule = ~std::uint32_t{0};

/// By rule: the next with the same preconditions and cost, or kNoRule. The goal's rule is like no other.
/// `costs` by operator, as in RelaxedTask.
std::vector<std::uint32_t> next_alike(const Rules& rules, std::span<const std::int32_t> costs);

/// Clears the mark of each effect (by place in Rules::effects.items()) for which another rule with a mark
/// needs no other preconditions and costs no more. `costs` by operator, as in RelaxedTask. Gives up where
/// lists of achievers are long; the work is bounded to well under a second.
void unmark_dominated(const Rules& rules, const Achievers& achievers, std::span<const std::int32_t> costs,
                      std::vector<char>& marks);

}  // namespace praxis::relaxed
