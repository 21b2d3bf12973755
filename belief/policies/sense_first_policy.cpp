#include "belief/policies/sense_first_policy.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace praxis::belief {
namespace {

/// A variable that was aimed at so often and is still unknown is given up.
constexpr std::uint32_t kMostAttempts = 4;
/// Wall seconds of the search for a way to one reading.
constexpr double kTargetSeconds = 0.25;

/// A planner for the same beliefs that also knows the readings that no plan needs.
std::shared_ptr<const KnowledgePlanner> with_all_readings(const Compilation& compilation) {
    CompilationOptions options = compilation.options();
    options.all_readings = true;
    return std::make_shared<const KnowledgePlanner>(
        std::make_shared<const Compilation>(compilation.shared_belief(), options));
}

}  // namespace

SenseFirstPolicy::SenseFirstPolicy(const PolicyContext& context)
    : planner_(with_all_readings(context.planner->compilation())),
      options_(context.options),
      prepared_(planner_->compilation().task()),
      attempts_(planner_->compilation().belief().uncertain.size(), 0) {
    const Compilation& compilation = planner_->compilation();
    const FiniteDomainTask& task = *compilation.task();
    for (std::size_t o = 0; o < task.operator_count(); ++o) {
        const CompiledOperator& origin = compilation.origin(OperatorId(o));
        if (origin.reads) targets_.push_back({origin.outcome.variable, origin.outcome, OperatorId(o)});
    }
    // Both outcomes of a reading have the same conditions: one is enough.
    const auto same_place = [&](const Target& a, const Target& b) {
        return a.variable == b.variable && std::ranges::equal(task.preconditions[a.reading.index()],
                                                              task.preconditions[b.reading.index()]);
    };
    targets_.erase(std::unique(targets_.begin(), targets_.end(), same_place), targets_.end());
}

Decision SenseFirstPolicy::next(Belief& belief, const Budget& budget) {
    while (sensing_) {
        if (const auto action = step(belief)) return {Decision::Kind::act, *action};
        sensing_ = budget.exhausted() == Stop::none && choose_target(belief, budget);
    }
    return {Decision::Kind::plan};
}

bool SenseFirstPolicy::open(const Belief& belief, const Target& target) const {
    return attempts_[static_cast<std::size_t>(target.variable)] < kMostAttempts &&
           belief.truth(target.outcome) == Truth::unknown;
}

std::optional<std::uint32_t> SenseFirstPolicy::step(const Belief& belief) {
    if (belief.truth(target_.outcome) != Truth::unknown) return std::nullopt;
    while (next_ < steps_.size()) {
        const std::uint32_t action = planner_->compilation().origin(steps_[next_]).action;
        const bool idle = planner_->superfluous(belief, steps_[next_]) || action == CompiledOperator::kNone;
        if (!idle && !belief.can(action)) return std::nullopt;
        ++next_;
        if (!idle) return action;
    }
    return std::nullopt;
}

bool SenseFirstPolicy::choose_target(Belief& belief, const Budget& budget) {
    const FiniteDomainTask& task = *planner_->compilation().task();
    Random random(options_.first.seed);
    belief.begin_plan(random);
    Query query{belief.values(), {}};
    for (std::size_t v = 0; v < query.initial_values.size(); ++v)
        if (task.derived(static_cast<std::int32_t>(v))) query.initial_values[v] = task.initial_values[v];
    steps_.clear();
    next_ = 0;
    const double start = processor_seconds();
    std::size_t shortest = std::numeric_limits<std::size_t>::max();
    for (const Target& target : targets_) {
        if (shortest <= 1) break;
        if (!open(belief, target)) continue;
        const auto condition = task.preconditions[target.reading.index()];
        std::vector<OperatorId> way;
        if (!all_hold(condition, belief.values().data())) {
            query.goal.assign(condition.begin(), condition.end());
            Outcome outcome = search(prepared_, query, options_.first, budget.within(kTargetSeconds));
            if (!outcome.plan) continue;
            way = std::move(*outcome.plan);
        }
        way.push_back(target.reading);
        if (way.size() >= shortest) continue;
        shortest = way.size();
        steps_ = std::move(way);
        target_ = target;
    }
    plan_seconds_.push_back(processor_seconds() - start);
    if (steps_.empty()) return false;
    ++attempts_[static_cast<std::size_t>(target_.variable)];
    return true;
}

}  // namespace praxis::belief
