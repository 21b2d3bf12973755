// Reaches propositions of a relaxed task in order of their hmax or hadd cost, until the goal is reached.
//
// Rules that miss nothing in the state fire first, at their own cost; then a generalised Dijkstra search
// counts down what the others miss. A rule's cost is summed when its last precondition is reached, so that
// counters of one byte a rule are all that must be reset.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "search/evaluators/cost_queue.hpp"
#include "search/evaluators/missing_preconditions.hpp"
#include "search/evaluators/relaxed_task.hpp"

namespace praxis {

/// How the costs of a rule's preconditions combine: the largest (hmax) or their sum (hadd).
enum class Combine : std::uint8_t { maximum, sum };

template <Combine combine>
class RelaxedExploration {
  public:
    explicit RelaxedExploration(std::shared_ptr<const RelaxedTask> task)
        : task_(std::move(task)),
          missing_(*task_),
          counters_(missing_.counts()),
          unreached_(task_->proposition_count, Reached{kDeadEnd, RelaxedTask::kNone}),
          reached_(unreached_),
          complete_(task_->rule_count() + 1) {
        unreached_[RelaxedTask::kTrue].cost = 0;
    }

    /// The cost of the goal, or kDeadEnd. Costs above kMaxCost count as kMaxCost.
    Estimate run(StateView state);

    static constexpr std::int32_t kMaxCost = 1 << 30;

    /// After `run`: the rule that reached a proposition most cheaply; kNone if it holds in the state or is
    /// not reached.
    std::uint32_t supporter(std::uint32_t proposition) const { return reached_[proposition].supporter; }
    const RelaxedTask& task() const { return *task_; }

  private:
    struct Reached {
        std::int32_t cost;
        std::uint32_t supporter;
    };

    void fire(std::uint32_t index, const RelaxedTask::Rule& rule, std::int32_t cost) {
        for (const std::uint32_t effect : rule.effects) {
            Reached& reached = reached_[effect];
            if (cost >= reached.cost) continue;
            reached = {cost, index};
            queue_.push(cost, effect);
        }
    }

    /// Whether no effect can become cheaper than it is, even if the precondition just reached, at cost
    /// `last`, were the only one that costs anything. Most rules end here.
    bool useless(const RelaxedTask::Rule& rule, std::int32_t last) const {
        const std::int64_t least = std::min(std::int64_t{last} + rule.cost, std::int64_t{kMaxCost});
        for (const std::uint32_t effect : rule.effects) {
            if (reached_[effect].cost > least) return false;
        }
        return true;
    }

    /// What a rule's effects cost once its last precondition is reached, at cost `last`. Saturates at each
    /// step, so that the compiler leaves the short loop alone.
    std::int32_t effect_cost(const RelaxedTask::Rule& rule, std::int32_t last) const {
        std::uint32_t cost = std::min(static_cast<std::uint32_t>(rule.cost), kLimit);
        if constexpr (combine == Combine::sum) {
            for (const std::uint32_t precondition : rule.preconditions) {
                cost = std::min(cost + static_cast<std::uint32_t>(reached_[precondition].cost), kLimit);
            }
        } else {
            cost = std::min(cost + static_cast<std::uint32_t>(last), kLimit);
        }
        return static_cast<std::int32_t>(cost);
    }

    static constexpr std::uint32_t kLimit = kMaxCost;
    static constexpr std::size_t kAhead = 6;  ///< rules

    std::shared_ptr<const RelaxedTask> task_;
    MissingPreconditions missing_;
    std::vector<std::uint8_t> counters_;  ///< by rule
    std::vector<Reached> unreached_;      ///< what `reached_` is reset to
    std::vector<Reached> reached_;        ///< by proposition
    std::vector<std::uint32_t>
        complete_;  ///< rules that miss nothing since the proposition in hand was reached
    CostQueue queue_;
};

template <Combine combine>
Estimate RelaxedExploration<combine>::run(StateView state) {
    std::memcpy(reached_.data(), unreached_.data(), reached_.size() * sizeof(Reached));
    missing_.enter(state, [this](std::uint32_t proposition) { reached_[proposition].cost = 0; });
    if (missing_.counts()[task_->goal_rule] == 0) {
        reached_[task_->goal] = {0, task_->goal_rule};
        return 0;
    }
    queue_.clear();
    missing_.for_each_applicable([this](std::uint32_t index) {
        const RelaxedTask::Rule rule = task_->rule(index);
        fire(index, rule, std::min(rule.cost, kMaxCost));
    });
    std::memcpy(counters_.data(), missing_.counts().data(), counters_.size());
    // Bytes may alias anything: without names of their own, every pointer would be loaded again for each
    // rule.
    const RelaxedTask& task = *task_;
    std::uint8_t* const counters = counters_.data();
    std::uint32_t* const complete_rules = complete_.data();
    CostQueue::Entry entry;
    while (queue_.pop(entry)) {
        if (entry.key != reached_[entry.item].cost) continue;
        std::size_t complete = 0;
        for (const std::uint32_t index : task.precondition_of(entry.item)) {
            complete_rules[complete] = index;
            complete += --counters[index] == 0;
        }
        for (std::size_t i = 0; i < complete; ++i) {
            task.prefetch(complete_rules[std::min(i + kAhead, complete - 1)]);
            const std::uint32_t index = complete_rules[i];
            const RelaxedTask::Rule rule = task.rule(index);
            if (useless(rule, entry.key)) continue;
            const std::int32_t cost = effect_cost(rule, entry.key);
            if (index == task.goal_rule) {
                reached_[task.goal] = {cost, index};
                return cost;
            }
            fire(index, rule, cost);
        }
    }
    return kDeadEnd;
}

}  // namespace praxis
