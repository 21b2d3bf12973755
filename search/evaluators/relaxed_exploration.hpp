// Reaches propositions of a relaxed task in order of their hmax or hadd cost, until the goal's cost is known.
//
// Rules that miss nothing in the state fire first, at their own cost; then a generalised Dijkstra search
// counts down what the others miss. It takes all propositions of one cost together, and works in passes over
// flat arrays that rarely branch another way than the time before: which rules are complete; which of these
// could make an effect cheaper, most cannot; and only for the rest, what the preconditions cost. Counters of
// one byte a rule and the propositions' costs are all that must be reset.
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
          unreached_(task_->proposition_count, kDeadEnd),
          costs_(unreached_),
          supporters_(task_->proposition_count, RelaxedTask::kNone),
          batch_(task_->proposition_count + 1),
          complete_(task_->rule_count() + 1 + kAhead) {
        unreached_[RelaxedTask::kTrue] = 0;
        for (std::uint32_t i = 0; i < task_->rule_count(); ++i) {
            if (i != task_->goal_rule) cheapest_ = std::min(cheapest_, task_->rule(i).cost);
        }
    }

    /// The cost of the goal, or kDeadEnd. Costs above kMaxCost count as kMaxCost.
    Estimate run(StateView state);

    static constexpr std::int32_t kMaxCost = 1 << 30;

    /// After `run`, for the goal and what its supporters need: the rule that reached a proposition most
    /// cheaply; kNone if it holds in the state.
    std::uint32_t supporter(std::uint32_t proposition) const { return supporters_[proposition]; }
    const RelaxedTask& task() const { return *task_; }
    /// About how many nanoseconds the last `run` took, by counting; see Evaluator.
    std::uint64_t effort() const {
        return 300 + (costs_.size() + counters_.size()) / 8 + 2 * looks_ + 8 * completed_;
    }

  private:
    void fire(std::uint32_t index, const RelaxedTask::Rule& rule, std::int32_t cost) {
        for (const std::uint32_t effect : rule.effects) {
            if (cost >= costs_[effect]) continue;
            costs_[effect] = cost;
            supporters_[effect] = index;
            queue_.push(cost, effect);
        }
    }

    /// What a rule's effects cost if all its preconditions are reached, the last of them at cost `last`.
    /// Saturates at each step, so that the compiler leaves the short loop alone.
    std::int32_t effect_cost(const RelaxedTask::Rule& rule, std::int32_t last) const {
        std::uint32_t cost = std::min(static_cast<std::uint32_t>(rule.cost), kLimit);
        if constexpr (combine == Combine::sum) {
            for (const std::uint32_t precondition : rule.preconditions) {
                cost = std::min(cost + static_cast<std::uint32_t>(costs_[precondition]), kLimit);
            }
        } else {
            cost = std::min(cost + static_cast<std::uint32_t>(last), kLimit);
        }
        return static_cast<std::int32_t>(cost);
    }

    std::int32_t goal_cost(const RelaxedTask::Rule& goal) const {
        std::int32_t dearest = 0;
        for (const std::uint32_t fact : goal.preconditions) dearest = std::max(dearest, costs_[fact]);
        return effect_cost(goal, dearest);
    }

    std::size_t find_complete(std::int32_t cost);
    std::size_t keep_useful(std::size_t complete, std::int32_t cost);

    static constexpr std::uint32_t kLimit = kMaxCost;
    static constexpr std::size_t kAhead = 6;  ///< rules

    std::shared_ptr<const RelaxedTask> task_;
    std::int32_t cheapest_ = kMaxCost;  ///< of the rules' costs
    MissingPreconditions missing_;
    std::vector<std::uint8_t> counters_;     ///< by rule
    std::vector<std::int32_t> unreached_;    ///< what `costs_` is reset to
    std::vector<std::int32_t> costs_;        ///< by proposition
    std::vector<std::uint32_t> supporters_;  ///< by proposition
    std::vector<std::uint32_t> batch_;       ///< propositions reached at the smallest cost
    std::vector<std::uint32_t> complete_;    ///< rules that miss nothing since the last propositions
    CostQueue queue_;
    std::uint64_t looks_ = 0;      ///< at rules, since the run began
    std::uint64_t completed_ = 0;  ///< of these
};

/// Takes the propositions of the smallest cost, `cost`, off the queue and collects the rules that miss
/// nothing since. Returns how many.
template <Combine combine>
std::size_t RelaxedExploration<combine>::find_complete(std::int32_t cost) {
    // Bytes may alias anything: without names of their own, every pointer would be loaded again for each
    // rule.
    const RelaxedTask& task = *task_;
    const std::int32_t* const costs = costs_.data();
    std::uint8_t* const counters = counters_.data();
    std::uint32_t* const complete_rules = complete_.data();
    std::uint32_t* const batch = batch_.data();
    std::size_t reached = 0;
    queue_.pop_all(cost, [&](std::uint32_t proposition) {
        task.prefetch_users(proposition);
        batch[reached] = proposition;
        reached += costs[proposition] == cost;
    });
    std::size_t complete = 0;
    for (std::size_t i = 0; i < reached; ++i) {
        const std::span<const std::uint32_t> users = task.precondition_of(batch[i]);
        looks_ += users.size();
        for (const std::uint32_t index : users) {
            complete_rules[complete] = index;
            complete += --counters[index] == 0;
        }
    }
    completed_ += complete;
    return complete;
}

/// Keeps the rules of which some effect would become cheaper if the precondition just reached, at cost
/// `cost`, were the only one that costs anything. Returns how many.
template <Combine combine>
std::size_t RelaxedExploration<combine>::keep_useful(std::size_t complete, std::int32_t cost) {
    const RelaxedTask& task = *task_;
    const std::int32_t* const costs = costs_.data();
    std::uint32_t* const rules = complete_.data();
    std::size_t useful = 0;
    for (std::size_t i = 0; i < complete; ++i) {
        task.prefetch_rule(rules[i + kAhead]);
        const RelaxedTask::Rule rule = task.rule(rules[i]);
        // Behind a single effect lies a precondition, which does not cost more than `cost`.
        std::int32_t dearest = std::max(costs[rule.effects.data()[0]], costs[rule.effects.data()[1]]);
        if (rule.effects.size() > 2) {
            for (const std::uint32_t effect : rule.effects.subspan(2)) {
                dearest = std::max(dearest, costs[effect]);
            }
        }
        rules[useful] = rules[i];
        const std::uint32_t least = static_cast<std::uint32_t>(cost) + static_cast<std::uint32_t>(rule.cost);
        useful += std::min(least, kLimit) < static_cast<std::uint32_t>(dearest);
    }
    return useful;
}

template <Combine combine>
Estimate RelaxedExploration<combine>::run(StateView state) {
    std::memcpy(costs_.data(), unreached_.data(), costs_.size() * sizeof(std::int32_t));
    missing_.enter(state, [this](std::uint32_t proposition) {
        costs_[proposition] = 0;
        supporters_[proposition] = RelaxedTask::kNone;
    });
    supporters_[task_->goal] = task_->goal_rule;
    looks_ = completed_ = 0;
    if (missing_.counts()[task_->goal_rule] == 0) return 0;
    queue_.clear();
    missing_.for_each_applicable([this](std::uint32_t index) {
        const RelaxedTask::Rule rule = task_->rule(index);
        fire(index, rule, std::min(rule.cost, kMaxCost));
    });
    std::memcpy(counters_.data(), missing_.counts().data(), counters_.size());
    const RelaxedTask::Rule goal = task_->rule(task_->goal_rule);
    auto open_goal = goal.preconditions.begin();  // all before it cost what they do
    for (std::int32_t cost = 0; queue_.smallest(cost);) {
        // Nothing becomes cheaper than this any more.
        const std::int32_t least = std::min(cost, kMaxCost - cheapest_) + cheapest_;
        while (open_goal != goal.preconditions.end() && costs_[*open_goal] <= least) ++open_goal;
        if (open_goal == goal.preconditions.end()) return goal_cost(goal);
        const std::size_t complete = find_complete(cost);
        const std::size_t useful = keep_useful(complete, cost);
        for (std::size_t i = 0; i < useful; ++i) {
            const RelaxedTask::Rule rule = task_->rule(complete_[i]);
            fire(complete_[i], rule, effect_cost(rule, cost));
        }
    }
    return kDeadEnd;
}

}  // namespace praxis
