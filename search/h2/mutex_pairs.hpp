// Mutex pairs by h2, forward and backward.
//
// Forward: two facts are mutex if h2 never reaches them together (Haslum & Geffner, AIPS 2000). Backward: the
// same on the regression of the task, from the goal; a pair that it does not reach cannot be part of a state
// from which the goal can be reached. What one direction excludes, the other need not consider: Alcázar &
// Torralba, "A Reminder about the Importance of Computing and Exploiting Invariants in Planning", ICAPS 2015.
// Unknown values in the regression are all values that are not mutex with what is known (disambiguation).
//
// Conditional effects: forward only, each effect as a step of its own. Derived variables: forward only, and
// what is said about them is ignored, so that they are never mutex with anything.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "search/budget.hpp"
#include "search/h2/pair_reachability.hpp"
#include "search/task/finite_domain_task.hpp"

namespace praxis {

/// What is known of the pairs of one task; sharpened by each call of `forward` and `backward`.
class MutexPairs {
  public:
    /// Keeps a reference to the task. Knows its variables and mutex groups. Memory: `bytes(task)`.
    explicit MutexPairs(const FiniteDomainTask& task);
    /// What the pairs and one analysis of them take at most.
    static std::size_t bytes(const FiniteDomainTask& task);

    /// False if the budget ran out; then nothing has been learnt.
    bool forward(const Budget& budget);
    /// The same. Only without axioms and conditional effects.
    bool backward(const Budget& budget);
    /// There is neither an axiom nor a conditional effect.
    bool can_go_backward() const { return can_go_backward_; }

    /// No state contains both that can be reached (after `backward`: and from which the goal can be reached).
    /// A fact that no such state contains is mutex with itself.
    bool mutex(Fact a, Fact b) const {
        return !task_.derived(a.variable) && !task_.derived(b.variable) &&
               !pairs_.test(task_.fact_number(a), task_.fact_number(b));
    }
    /// No two of the facts are mutex.
    bool possible(std::span<const Fact> facts) const;
    /// The operator may be applied in such a state and lead to one.
    bool possible(OperatorId id) const { return operator_possible_[id.index()]; }
    /// The effect (by its place in `FiniteDomainTask::effects`) may fire.
    bool effect_possible(std::size_t place) const { return effect_possible_[place]; }
    /// There is no plan.
    bool unsolvable() const { return unsolvable_; }
    /// Numbers that only ever shrink: pairs not mutex, operators and effects possible.
    std::size_t pair_count() const { return pairs_.count(); }
    std::size_t possible_count() const;

  private:
    PairSteps forward_steps() const;
    PairSteps backward_steps() const;
    std::vector<std::uint32_t> numbers(std::span<const Fact> facts) const;
    std::vector<std::uint32_t> unconditional(std::size_t op) const;
    bool goal_facts(FactBits& facts) const;
    void learn(PairReachability& analysis, bool backward);

    const FiniteDomainTask& task_;
    ValueCheck values_;
    PairMatrix pairs_;  // not mutex
    std::vector<bool> operator_possible_;
    std::vector<bool> effect_possible_;
    std::vector<std::uint32_t> variable_of_;  // by fact number
    bool can_go_backward_;
    bool unsolvable_ = false;
};

}  // namespace praxis
