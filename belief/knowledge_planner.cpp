#include "belief/knowledge_planner.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "search/thread_time.hpp"

namespace praxis::belief {
KnowledgePlanner::KnowledgePlanner(std::shared_ptr<const Compilation> compilation, const Budget& budget)
    : compilation_(std::move(compilation)),
      prepared_(compilation_->task(), budget),
      axioms_(*compilation_->task()) {}

KnowledgePlan KnowledgePlanner::plan(const Belief& belief, const Configuration& configuration,
                                     const Budget& budget) const {
    const FiniteDomainTask& task = *compilation_->task();
    KnowledgePlan result;
    const double start = thread_seconds();
    Query query{belief.values(), task.goal};
    for (std::size_t v = 0; v < query.initial_values.size(); ++v)
        if (task.derived(static_cast<std::int32_t>(v))) query.initial_values[v] = task.initial_values[v];
    try {
        Outcome outcome = search(prepared_, query, configuration, budget);
        result.status = outcome.plan ? Status::solved : outcome.status;
        if (outcome.plan) result.steps = std::move(*outcome.plan);
    } catch (const std::bad_alloc&) {
        result.status = Status::out_of_memory;
    }
    result.seconds = thread_seconds() - start;
    return result;
}

bool KnowledgePlanner::superfluous(const Belief& belief, OperatorId step) const {
    const CompiledOperator& origin = compilation_->origin(step);
    if (origin.action == CompiledOperator::kNone) return true;
    return origin.reads && !compilation_->acts(origin.action) && belief.knows(origin.outcome);
}

bool KnowledgePlanner::possible_in_slots(const std::vector<std::int32_t>& values, Fact fact) const {
    const Components& components = compilation_->components();
    const auto variable = static_cast<std::size_t>(fact.variable);
    const CompiledComponent& slots = compilation_->slots()[components.component_of[variable]];
    const std::uint32_t column = components.column_of[variable];
    for (std::size_t slot = 0; slot < slots.possible.size(); ++slot)
        if (values[static_cast<std::size_t>(slots.possible[slot])] == 1 &&
            values[static_cast<std::size_t>(slots.values[slot][column])] == fact.value)
            return true;
    return false;
}

bool KnowledgePlanner::some_case_left(const std::vector<std::int32_t>& values) const {
    const auto& components = compilation_->slots();
    return std::all_of(components.begin(), components.end(), [&](const CompiledComponent& slots) {
        return std::any_of(slots.possible.begin(), slots.possible.end(), [&](std::int32_t variable) {
            return values[static_cast<std::size_t>(variable)] == 1;
        });
    });
}

bool KnowledgePlanner::apply(std::vector<std::int32_t>& values, OperatorId step) const {
    const FiniteDomainTask& task = *compilation_->task();
    const CompiledOperator& origin = compilation_->origin(step);
    if (origin.reads && compilation_->tracked(origin.outcome.variable)) {
        // Where all cases agree by now, the reading goes without saying, or is not as the plan needs it.
        const auto possible = [&](Fact fact) { return possible_in_slots(values, fact); };
        const bool other = possible({origin.outcome.variable, 1 - origin.outcome.value});
        if (!possible(origin.outcome)) return false;
        if (!other && (origin.action == CompiledOperator::kNone || !compilation_->acts(origin.action)))
            return true;
        for (const Fact& fact : task.preconditions[step.index()])
            if (!task.derived(fact.variable) && values[static_cast<std::size_t>(fact.variable)] != fact.value)
                return false;
        if (other && !all_hold(task.preconditions[step.index()], values.data())) return false;
    } else if (origin.reads) {
        const Fact known = compilation_->known(origin.outcome);
        const bool already = values[static_cast<std::size_t>(known.variable)] == known.value;
        const bool acts = origin.action != CompiledOperator::kNone && compilation_->acts(origin.action);
        if (already && !acts) return true;
        const std::int32_t basic = compilation_->variable(origin.outcome.variable);
        for (const Fact& fact : task.preconditions[step.index()])
            if (values[static_cast<std::size_t>(fact.variable)] != fact.value &&
                !(already && fact.variable == basic))
                return false;
    } else if (!all_hold(task.preconditions[step.index()], values.data())) {
        return false;
    }
    before_ = values;
    for (const GroundEffect& effect : task.effects[step.index()])
        if (effect.condition == 0 || all_hold(task.conditions[effect.condition], before_.data()))
            values[static_cast<std::size_t>(effect.fact.variable)] = effect.fact.value;
    for (std::size_t v = 0; v < values.size(); ++v)
        if (task.derived(static_cast<std::int32_t>(v))) values[v] = task.initial_values[v];
    axioms_.complete(values.data(), scratch_);
    return true;
}

bool KnowledgePlanner::still_good(const Belief& belief, const std::vector<OperatorId>& steps,
                                  std::size_t next) const {
    values_ = belief.values();
    if (!some_case_left(values_)) return false;
    for (std::size_t i = next; i < steps.size(); ++i)
        if (!apply(values_, steps[i])) return false;
    return all_hold(compilation_->task()->goal, values_.data());
}

}  // namespace praxis::belief
