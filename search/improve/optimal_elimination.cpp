#include "search/improve/optimal_elimination.hpp"

#include <algorithm>

namespace praxis {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::size_t kStepsBetweenLooks = 1024;
// Words of a registered state: the round in which it was last an entry, and the number of that entry.
constexpr std::size_t kRound = 0;
constexpr std::size_t kEntry = 1;
constexpr std::size_t kNodeWords = 2;

}  // namespace

OptimalElimination::OptimalElimination(const PreparedTask::Parts& parts, const Query& query,
                                       std::span<const OperatorId> plan, const Budget& budget,
                                       const EliminationLimits& limits)
    : parts_(parts),
      query_(query),
      plan_(plan),
      budget_(budget),
      limits_(limits),
      execution_(parts, query),
      registry_(parts.packer, kNodeWords),
      necessary_(plan.size(), false),
      reached_(parts.task->fact_count(), 0),
      values_(parts.task->variable_count()) {
    for (OperatorId op : plan) {
        derived_condition_.push_back(
            std::ranges::any_of(parts.task->preconditions[op.index()],
                                [&](const Fact& fact) { return parts.task->derived(fact.variable); }));
    }
}

bool OptimalElimination::spent() {
    ++steps_;
    if (++unlooked_ < kStepsBetweenLooks) return false;
    unlooked_ = 0;
    return steps_ > limits_.max_steps || budget_.exhausted() != Stop::none;
}

std::optional<std::vector<OperatorId>> OptimalElimination::run(PlanCost bound) {
    if (budget_.exhausted() != Stop::none || !find_necessary()) return std::nullopt;
    find_last_achievers();
    rest_.assign(plan_.size() + 1, {});
    for (std::size_t i = plan_.size(); i-- > 0;) {
        rest_[i] = rest_[i + 1] + (necessary_[i] ? execution_.cost(plan_[i]) : PlanCost{});
    }

    values_ = execution_.initial();
    parts_.packer.pack(values_.data(), registry_.candidate());
    const StateId initial = registry_.intern().first;
    registry_.node(initial)[kRound] = 0;
    ways_.push_back({kNone, 0, {}});
    current_.push_back({initial, 0});
    for (std::size_t step = 0; step < plan_.size() && !current_.empty(); ++step) {
        if (!pass_step(step, bound)) return std::nullopt;
    }
    finished_ = true;
    std::uint32_t best = kNone;
    for (const Entry entry : current_) {
        const PlanCost cost = ways_[entry.way].cost;
        if (cost >= bound) continue;
        execution_.read(registry_.words(entry.state), values_);
        if (!execution_.goal(values_)) continue;
        bound = cost;
        best = entry.way;
    }
    if (best == kNone) return std::nullopt;
    return steps_of(best);
}

bool OptimalElimination::find_necessary() {
    // Without step i, neither the goal nor a necessary step later on must be reachable; from the last step to
    // the first, so that those are known.
    for (std::size_t i = plan_.size(); i-- > 0;) {
        if (steps_ > limits_.max_steps / 2) return true;
        necessary_[i] = !reachable_without(i);
        for (std::size_t j = 0; j < plan_.size(); ++j) {
            if (spent()) return budget_.exhausted() == Stop::none;
        }
    }
    return true;
}

bool OptimalElimination::reachable_without(std::size_t left_out) {
    const FiniteDomainTask& task = *parts_.task;
    ++mark_;
    const auto holds = [&](std::span<const Fact> facts) {
        return std::ranges::all_of(facts, [&](const Fact& fact) {
            return task.derived(fact.variable) || reached_[task.fact_number(fact)] == mark_;
        });
    };
    for (std::size_t variable = 0; variable < task.variable_count(); ++variable) {
        reached_[task.fact_number({static_cast<std::int32_t>(variable), query_.initial_values[variable]})] =
            mark_;
    }
    for (std::size_t i = 0; i < plan_.size(); ++i) {
        if (i == left_out) continue;
        const OperatorId op = plan_[i];
        if (!holds(task.preconditions[op.index()])) {
            if (necessary_[i]) return false;
            continue;
        }
        for (const GroundEffect& effect : task.effects[op.index()]) {
            if (holds(task.conditions[effect.condition])) reached_[task.fact_number(effect.fact)] = mark_;
        }
    }
    return holds(query_.goal);
}

void OptimalElimination::find_last_achievers() {
    const FiniteDomainTask& task = *parts_.task;
    for (const Fact& fact : query_.goal) {
        if (task.derived(fact.variable)) continue;
        std::size_t last = 0;
        for (std::size_t i = 0; i < plan_.size(); ++i) {
            for (const GroundEffect& effect : task.effects[plan_[i].index()]) {
                if (effect.fact == fact) last = i + 1;
            }
        }
        goal_.push_back({fact, last});
    }
}

// Turns the entries before the step into those after it; false if the limits do not suffice.
bool OptimalElimination::pass_step(std::size_t step, PlanCost bound) {
    const auto round = static_cast<std::uint32_t>(step + 1);
    next_.clear();
    for (const Entry entry : current_) {
        if (spent() || ways_.size() >= limits_.max_nodes || registry_.size() >= limits_.max_nodes) {
            return false;
        }
        if (!necessary_[step] && !hopeless(entry.state, step + 1)) keep(entry, round);
        const PlanCost cost = ways_[entry.way].cost + execution_.cost(plan_[step]);
        if (cost + rest_[step + 1] >= bound || !take(step, entry)) continue;
        const auto [state, is_new] = registry_.intern();
        if (is_new) registry_.node(state)[kRound] = 0;
        if (state == entry.state || hopeless(state, step + 1)) continue;
        ways_.push_back({entry.way, static_cast<std::uint32_t>(step), cost});
        keep({state, static_cast<std::uint32_t>(ways_.size() - 1)}, round);
    }
    std::swap(current_, next_);
    return true;
}

// Writes the state after the step as the registry's candidate; false if the step is not applicable.
bool OptimalElimination::take(std::size_t step, Entry entry) {
    const OperatorId op = plan_[step];
    const std::uint32_t* words = registry_.words(entry.state);
    if (derived_condition_[step] || parts_.transitions.conditional(op)) {
        execution_.read(words, values_);
        if (!execution_.applicable(op, values_)) return false;
    } else {
        for (const Fact& fact : parts_.task->preconditions[op.index()]) {
            if (parts_.packer.get(words, fact.variable) != fact.value) return false;
        }
    }
    parts_.transitions.apply(op, values_.data(), registry_.candidate_from(entry.state));
    return true;
}

void OptimalElimination::keep(Entry entry, std::uint32_t round) {
    std::uint32_t* node = registry_.node(entry.state);
    if (node[kRound] == round) {
        Entry& known = next_[node[kEntry]];
        if (ways_[entry.way].cost < ways_[known.way].cost) known = entry;
        return;
    }
    node[kRound] = round;
    node[kEntry] = static_cast<std::uint32_t>(next_.size());
    next_.push_back(entry);
}

// A goal fact does not hold and no step from `next_step` on adds it.
bool OptimalElimination::hopeless(StateId state, std::size_t next_step) const {
    const std::uint32_t* words = registry_.words(state);
    return std::ranges::any_of(goal_, [&](const GoalFact& goal) {
        return goal.last <= next_step && parts_.packer.get(words, goal.fact.variable) != goal.fact.value;
    });
}

std::vector<OperatorId> OptimalElimination::steps_of(std::uint32_t way) const {
    std::vector<OperatorId> steps;
    for (; ways_[way].parent != kNone; way = ways_[way].parent) steps.push_back(plan_[ways_[way].step]);
    std::ranges::reverse(steps);
    return steps;
}

}  // namespace praxis
