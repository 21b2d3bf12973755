// The delete relaxation of a task, in the form that hmax, hadd, FF and LM-cut explore.
//
// Vocabulary. A *proposition* is a fact that some condition or the goal needs and that matters for the goal.
// Once reached, it stays reached. A *rule* reaches its effects once all its preconditions are reached, for
// the cost of its operator. An operator without conditional effects is one rule with many effects; otherwise
// there is one rule for each different effect condition, whose precondition is the operator's joined with the
// condition. Axioms are rules without cost. Rules with the same preconditions and cost may be merged: a rule
// has *parts*, one for each operator. Parts that are no operator's have operator_count as `operator_of`.
//
// Two propositions are made up: kTrue, which always holds and is the precondition of rules that need nothing,
// and `goal`, which `goal_rule` reaches from all goal facts at cost 0.
//
// Derived variables. The non-default value is reached by axioms. The default value holds if every axiom for
// the variable fails: for each axiom there is a made-up proposition "its body is false", reached by a rule
// from each other value of a variable in the body, and one rule leads from these to the default value. This
// has the size of the axioms, but is unsound for derived variables that depend on themselves (all would wait
// for each other), so default values of these count as always reached; and so do all where the rules would
// grow too many. Either way whatever a plan can reach is reached in the relaxation, at no greater cost: an
// unreached goal proves that there is no plan, and hmax and LM-cut stay admissible.
//
// Rules with more than kMaxPreconditions preconditions are split by made-up propositions, so that counters
// fit into bytes. Everything is flat and immutable, to be shared by evaluators and threads. Limits: 2^32 - 1
// rules, propositions and entries, 2^24 effects of a rule.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "search/evaluators/evaluator.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

struct RelaxedTask {
    /// Whether effects that another rule has for no greater cost and no further precondition are dropped, and
    /// rules with the same preconditions and cost become one. That keeps hmax and hadd values; LM-cut must
    /// not do it: an operator's effects then no longer share its cost.
    enum class Dominance : std::uint8_t { keep, drop };

    RelaxedTask(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type,
                Dominance dominance);

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    static constexpr std::uint32_t kTrue = 0;
    static constexpr std::size_t kMaxPreconditions = 255;

    /// A rule's record in `records`: cost, number of effects times 256 plus number of preconditions, effects,
    /// preconditions.
    struct Rule {
        std::int32_t cost;
        std::span<const std::uint32_t> preconditions;
        std::span<const std::uint32_t> effects;
    };
    Rule rule(std::uint32_t index) const {
        const std::uint32_t* const record = records.data() + record_begin[index];
        const std::uint32_t* const effects = record + 2;
        const std::uint32_t effect_count = record[1] >> 8;
        return {static_cast<std::int32_t>(record[0]),
                {effects + effect_count, record[1] & 255},
                {effects, effect_count}};
    }
    /// The part of a rule that has an effect.
    std::uint32_t part(std::uint32_t index, std::uint32_t effect) const;
    /// Start to bring a rule's record or the list of a proposition's rules from memory.
    void prefetch_rule(std::uint32_t index) const { prefetch(records.data() + record_begin[index]); }
    void prefetch_users(std::uint32_t proposition) const {
        const std::uint32_t* const list = users.data() + users_begin[proposition];
        prefetch(list);
        prefetch(list + 16);
    }
    std::span<const std::uint32_t> precondition_of(std::uint32_t proposition) const {
        return {users.data() + users_begin[proposition], users.data() + users_begin[proposition + 1]};
    }
    std::uint32_t rule_count() const { return static_cast<std::uint32_t>(record_begin.size()); }

    std::uint32_t proposition_count = 0;
    std::vector<std::uint32_t> first_fact;        ///< as in the task
    std::vector<std::uint32_t> fact_proposition;  ///< by fact number; kNone: not needed
    std::vector<std::uint32_t> users_begin;       ///< by proposition; see precondition_of
    std::vector<std::uint32_t> users;

    std::vector<std::uint32_t> record_begin;  ///< by rule
    std::vector<std::uint32_t> records;
    std::vector<std::uint8_t> precondition_counts;  ///< by rule

    // The parts of rules: what they have from one operator. With Dominance::keep, each rule is one part.
    std::vector<std::uint32_t> parts_begin;   ///< by rule
    std::vector<std::uint32_t> part_end;      ///< by part: place after its last effect among the rule's
    std::vector<std::uint32_t> operator_of;   ///< by part
    std::vector<std::uint32_t> condition_of;  ///< by part: number of the effect condition; empty: all are 0

    std::uint32_t operator_count = 0;
    std::vector<std::int32_t> costs;  ///< by operator; one more, zero, for rules that are no operator's
    std::uint32_t goal = 0;
    std::uint32_t goal_rule = 0;

  private:
    static void prefetch([[maybe_unused]] const std::uint32_t* place) {
#if defined(__GNUC__)
        __builtin_prefetch(place);
#endif
    }
};

}  // namespace praxis
