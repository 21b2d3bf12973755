#include "search/evaluators/lmcut.hpp"

#include <algorithm>
#include <cstring>

namespace praxis {

namespace {

constexpr std::int32_t kUnreached = kDeadEnd;
constexpr std::int32_t kMaxCost = 1 << 30;

/// lists[key] = all rules with that key, for keys below `count`. `keys(rule)` calls its argument with each
/// key.
template <class Keys>
PackedLists<std::uint32_t> rules_by(std::uint32_t count, std::uint32_t rule_count, const Keys& keys) {
    std::vector<std::uint32_t> begin(count + 1, 0);
    for (std::uint32_t rule = 0; rule < rule_count; ++rule) {
        keys(rule, [&](std::uint32_t key) { ++begin[key + 1]; });
    }
    for (std::uint32_t key = 0; key < count; ++key) begin[key + 1] += begin[key];
    std::vector<std::uint32_t> next = begin;
    std::vector<std::uint32_t> items(begin.back());
    for (std::uint32_t rule = 0; rule < rule_count; ++rule) {
        keys(rule, [&](std::uint32_t key) { items[next[key]++] = rule; });
    }
    PackedLists<std::uint32_t> lists;
    lists.reserve(count, items.size());
    for (std::uint32_t key = 0; key < count; ++key) {
        lists.append(std::span(items).subspan(begin[key], begin[key + 1] - begin[key]));
    }
    return lists;
}

}  // namespace

LMCutEvaluator::LMCutEvaluator(const FiniteDomainTask& task, std::span<const Fact> goal, CostType cost_type)
    : task_(task, goal, cost_type, RelaxedTask::Dominance::keep),
      achievers_(rules_by(task_.proposition_count, task_.rule_count(),
                          [this](std::uint32_t rule, const auto& add) {
                              for (const std::uint32_t effect : task_.rule(rule).effects) add(effect);
                          })),
      operator_rules_(
          rules_by(task_.operator_count + 1, task_.rule_count(),
                   [this](std::uint32_t rule, const auto& add) { add(task_.operator_of[rule]); })),
      missing_(task_),
      counters_(missing_.counts()),
      supporters_(task_.rule_count()),
      unreached_(task_.proposition_count, kUnreached),
      reached_cost_(unreached_),
      costs_(task_.costs),
      zone_marks_(task_.proposition_count, 0),
      before_marks_(zone_marks_),
      behind_marks_(zone_marks_),
      trace_marks_(zone_marks_),
      cut_marks_(task_.operator_count, 0) {
    unreached_[RelaxedTask::kTrue] = 0;
}

Estimate LMCutEvaluator::evaluate(StateView state) {
    std::ranges::copy(unreached_, reached_cost_.begin());
    missing_.enter(state, [this](std::uint32_t proposition) { reached_cost_[proposition] = 0; });
    if (missing_.counts()[task_.goal_rule] == 0) return 0;
    std::ranges::copy(task_.costs, costs_.begin());
    explore();
    const std::int32_t hmax = reached_cost_[task_.goal];
    if (hmax == kUnreached || hmax >= kMaxCost) return hmax;
    std::int64_t estimate = 0;
    while (reached_cost_[task_.goal] > 0) {
        next_round();
        mark_goal_zone();
        find_cut();
        estimate += reduce_cut();
        repair();
    }
    return static_cast<Estimate>(std::clamp<std::int64_t>(estimate, hmax, kDeadEnd - 1));
}

inline void LMCutEvaluator::reach(std::uint32_t proposition, std::int32_t cost) {
    if (cost < reached_cost_[proposition]) {
        reached_cost_[proposition] = cost;
        queue_.push(cost, proposition);
    }
}

/// Reaches the effects of a rule whose supporter is known.
inline void LMCutEvaluator::fire(std::uint32_t rule) {
    const std::int64_t sum = std::int64_t{supporters_[rule].cost} + cost_of(rule);
    const auto cost = static_cast<std::int32_t>(std::min<std::int64_t>(sum, kMaxCost));
    for (const std::uint32_t effect : task_.rule(rule).effects) reach(effect, cost);
}

/// hmax of all propositions, and all supporters.
void LMCutEvaluator::explore() {
    queue_.clear();
    missing_.for_each_applicable([this](std::uint32_t rule) {
        supporters_[rule] = {task_.rule(rule).preconditions.front(), 0};
        fire(rule);
    });
    std::memcpy(counters_.data(), missing_.counts().data(), counters_.size());
    CostQueue::Entry entry;
    while (queue_.pop(entry)) {
        if (entry.key != reached_cost_[entry.item]) continue;
        for (const std::uint32_t rule : task_.precondition_of(entry.item)) {
            if (--counters_[rule] != 0) continue;
            supporters_[rule] = most_expensive(rule);
            fire(rule);
        }
    }
}

void LMCutEvaluator::next_round() {
    if (++round_ != 0) return;
    for (auto* marks : {&zone_marks_, &before_marks_, &behind_marks_, &cut_marks_})
        std::ranges::fill(*marks, 0u);
    round_ = 1;
}

void LMCutEvaluator::mark_goal_zone() {
    zone_.assign(1, task_.goal);
    zone_marks_[task_.goal] = round_;
    for (std::size_t done = 0; done < zone_.size(); ++done) {
        for (const std::uint32_t rule : achievers_[zone_[done]]) {
            if (cost_of(rule) != 0 || !reached(rule)) continue;
            const std::uint32_t supporter = supporters_[rule].proposition;
            if (in_zone(supporter)) continue;
            zone_marks_[supporter] = round_;
            zone_.push_back(supporter);
        }
    }
}

void LMCutEvaluator::find_cut() {
    cut_.clear();
    for (const std::uint32_t proposition : zone_) {
        for (const std::uint32_t rule : achievers_[proposition]) {
            const std::uint32_t op = task_.operator_of[rule];
            if (costs_[op] == 0 || cut_marks_[op] == round_ || !reached(rule)) continue;
            if (!before_zone(supporters_[rule])) continue;
            cut_marks_[op] = round_;
            cut_.push_back(op);
        }
    }
}

bool LMCutEvaluator::enters_zone(std::uint32_t rule) const {
    return std::ranges::any_of(task_.rule(rule).effects,
                               [this](std::uint32_t effect) { return in_zone(effect); });
}

/// Whether the proposition can be reached, from supporters to effects, without passing through the zone.
bool LMCutEvaluator::before_zone(Supporter supporter) {
    const std::int32_t goal_cost = reached_cost_[task_.goal];
    const std::uint32_t proposition = supporter.proposition;
    if (supporter.cost < goal_cost || before_marks_[proposition] == round_) return true;
    if (in_zone(proposition) || behind_marks_[proposition] == round_) return false;
    if (++trace_ == 0) {
        std::ranges::fill(trace_marks_, 0u);
        trace_ = 1;
    }
    traced_.assign(1, proposition);
    trace_marks_[proposition] = trace_;
    for (std::size_t done = 0; done < traced_.size(); ++done) {
        for (const std::uint32_t rule : achievers_[traced_[done]]) {
            if (!reached(rule) || enters_zone(rule)) continue;
            const Supporter next = supporters_[rule];
            if (next.cost < goal_cost || before_marks_[next.proposition] == round_) {
                before_marks_[proposition] = round_;
                return true;
            }
            if (in_zone(next.proposition) || behind_marks_[next.proposition] == round_ ||
                trace_marks_[next.proposition] == trace_) {
                continue;
            }
            trace_marks_[next.proposition] = trace_;
            traced_.push_back(next.proposition);
        }
    }
    for (const std::uint32_t seen : traced_) behind_marks_[seen] = round_;
    return false;
}

/// Takes the cost of the cut's cheapest operator off all its operators, and returns it.
std::int32_t LMCutEvaluator::reduce_cut() {
    std::int32_t cheapest = kUnreached;
    for (const std::uint32_t op : cut_) cheapest = std::min(cheapest, costs_[op]);
    for (const std::uint32_t op : cut_) costs_[op] -= cheapest;
    return cheapest;
}

/// The first of a rule's most expensive preconditions. (Ties broken by cost alone make the estimate a
/// function of the state; on initial states of IPC tasks the first gives higher estimates than the last, and
/// than keeping the old supporter.)
LMCutEvaluator::Supporter LMCutEvaluator::most_expensive(std::uint32_t rule) const {
    Supporter best{RelaxedTask::kTrue, -1};
    for (const std::uint32_t precondition : task_.rule(rule).preconditions) {
        if (reached_cost_[precondition] > best.cost) best = {precondition, reached_cost_[precondition]};
    }
    return best;
}

/// Repairs hmax and supporters after the cut's operators became cheaper.
void LMCutEvaluator::repair() {
    queue_.clear();
    for (const std::uint32_t op : cut_) {
        for (const std::uint32_t rule : operator_rules_[op]) {
            if (reached(rule)) fire(rule);
        }
    }
    CostQueue::Entry entry;
    while (queue_.pop(entry)) {
        if (entry.key != reached_cost_[entry.item]) continue;
        for (const std::uint32_t rule : task_.precondition_of(entry.item)) {
            if (supporters_[rule].proposition != entry.item || !reached(rule)) continue;
            const std::int32_t before = supporters_[rule].cost;
            supporters_[rule] = most_expensive(rule);
            if (supporters_[rule].cost < before) fire(rule);
        }
    }
}

}  // namespace praxis
