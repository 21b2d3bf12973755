#include "search/landmarks/exclusion_reachability.hpp"

#include <limits>
#include <numeric>

namespace praxis {

ExclusionReachability::ExclusionReachability(const FiniteDomainTask& task, std::span<const Fact> goal,
                                             std::span<const std::int32_t> initial_values)
    : task_(task),
      rules_(relaxed::make_rules(task, goal, std::numeric_limits<std::size_t>::max())),
      achievers_(rules_),
      users_begin_(rules_.fact_count + 1, 0),
      users_(rules_.preconditions.total()),
      initially_reached_(rules_.fact_count, 0),
      excluded_(rules_.fact_count, 0),
      barred_(task.operator_count() + 1, 0) {
    for (std::size_t v = 0; v < task.variable_count(); ++v) {
        variable_of_.insert(variable_of_.end(), static_cast<std::size_t>(task.domain_sizes[v]),
                            static_cast<std::int32_t>(v));
    }
    for (const std::uint32_t fact : rules_.preconditions.items()) ++users_begin_[fact];
    std::exclusive_scan(users_begin_.begin(), users_begin_.end(), users_begin_.begin(), 0u);
    std::vector<std::uint32_t> next(users_begin_.begin(), users_begin_.end() - 1);
    for (std::uint32_t rule = 0; rule < rules_.size(); ++rule) {
        for (const std::uint32_t fact : rules_.preconditions[rule]) users_[next[fact]++] = rule;
    }
    for (std::size_t v = 0; v < task.variable_count(); ++v) {
        initially_reached_[task.fact_number({static_cast<std::int32_t>(v), initial_values[v]})] = 1;
    }
    initially_unreached_.resize(rules_.size());
    for (std::uint32_t rule = 0; rule < rules_.size(); ++rule) {
        for (const std::uint32_t fact : rules_.preconditions[rule]) {
            if (!initially_reached_[fact]) ++initially_unreached_[rule];
        }
        if (initially_unreached_[rule] == 0) initially_applicable_.push_back(rule);
    }
    work_ = rules_.preconditions.total() + rules_.effects.total();
}

void ExclusionReachability::explore(std::span<const std::uint32_t> excluded) {
    ++stamp_;
    for (const std::uint32_t fact : excluded) {
        excluded_[fact] = stamp_;
        bar_sure_achievers(fact);
    }
    reached_ = initially_reached_;
    unreached_ = initially_unreached_;
    work_ += (reached_.size() + unreached_.size()) / 8;
    queue_.clear();
    for (const std::uint32_t rule : initially_applicable_) fire(rule);
    while (!queue_.empty()) {
        const std::uint32_t fact = queue_.back();
        queue_.pop_back();
        work_ += 1 + users_begin_[fact + 1] - users_begin_[fact];
        for (std::uint32_t i = users_begin_[fact]; i < users_begin_[fact + 1]; ++i) {
            if (--unreached_[users_[i]] == 0) fire(users_[i]);
        }
    }
}

void ExclusionReachability::fire(std::uint32_t rule) {
    if (barred(rule)) return;
    for (const std::uint32_t fact : rules_.effects[rule]) {
        if (reached_[fact] || excluded_[fact] == stamp_) continue;
        reached_[fact] = 1;
        queue_.push_back(fact);
    }
    work_ += 1 + rules_.effects[rule].size();
}

void ExclusionReachability::bar_sure_achievers(std::uint32_t excluded) {
    const std::int32_t variable = variable_of_[excluded];
    const Fact fact{
        variable, static_cast<std::int32_t>(excluded - task_.first_fact[static_cast<std::size_t>(variable)])};
    for (const relaxed::Achievers::Entry entry : achievers_.of(excluded)) {
        const std::uint32_t op = rules_.operators[entry.rule];
        if (op < task_.operator_count() && rules_.conditions[entry.rule] == 0 && surely_reaches(op, fact)) {
            barred_[op] = stamp_;
        }
    }
}

bool ExclusionReachability::surely_reaches(std::uint32_t op, Fact fact) const {
    bool sure = false;  // the later effect wins
    for (const GroundEffect& effect : task_.effects[op]) {
        if (effect.fact.variable != fact.variable) continue;
        if (effect.fact.value != fact.value) {
            sure = false;
        } else if (effect.condition == 0) {
            sure = true;
        }
    }
    return sure;
}

}  // namespace praxis
