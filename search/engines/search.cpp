#include "search/engines/search.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "search/engines/call.hpp"
#include "search/engines/prepared_parts.hpp"
#include "search/engines/registry.hpp"
#include "search/engines/search_context.hpp"
#include "search/engines/syntax.hpp"
#include "search/improve/plan_execution.hpp"

namespace praxis {

namespace {

void check(const FiniteDomainTask& task, const Query& query) {
    if (query.initial_values.size() != task.variable_count()) {
        throw std::invalid_argument("the query's initial state has " +
                                    std::to_string(query.initial_values.size()) + " values, the task has " +
                                    std::to_string(task.variable_count()) + " variables");
    }
    const auto in_range = [&](std::size_t variable, std::int32_t value) {
        return variable < task.variable_count() && value >= 0 && value < task.domain_sizes[variable];
    };
    for (std::size_t i = 0; i < query.initial_values.size(); ++i) {
        if (!in_range(i, query.initial_values[i])) {
            throw std::invalid_argument("the query's initial state has a value out of range");
        }
    }
    for (const Fact& fact : query.goal) {
        if (fact.variable < 0 || !in_range(static_cast<std::size_t>(fact.variable), fact.value)) {
            throw std::invalid_argument("the query's goal has a fact that the task does not have");
        }
    }
}

}  // namespace

PreparedTask::PreparedTask(std::shared_ptr<const FiniteDomainTask> task, const Budget& budget)
    : parts_(std::make_unique<const Parts>(std::move(task), budget)) {}
PreparedTask::~PreparedTask() = default;
PreparedTask::PreparedTask(PreparedTask&&) noexcept = default;
PreparedTask& PreparedTask::operator=(PreparedTask&&) noexcept = default;
const FiniteDomainTask& PreparedTask::task() const {
    return *parts_->task;
}
Stop PreparedTask::stop() const {
    return parts_->stop;
}

void SearchStatistics::add_counts(const SearchStatistics& other) {
    expanded += other.expanded;
    evaluated += other.evaluated;
    generated += other.generated;
    reopened += other.reopened;
    dead_ends += other.dead_ends;
}

Query task_query(const FiniteDomainTask& task) {
    return {task.initial_values, task.goal};
}

Configuration configuration(const std::string& expression) {
    check_expression(expression);
    Configuration result;
    result.expression = expression;
    return result;
}

Configuration alias(const std::string& name) {
    std::vector<std::string> names;
    std::string all;
    for (const AliasDescription& description : list_aliases()) {
        if (description.name == name) return configuration(description.expression);
        names.push_back(description.name);
        all += (all.empty() ? "" : ", ") + description.name;
    }
    const std::string closest = closest_name(name, names);
    throw std::invalid_argument("there is no alias '" + name + "'" +
                                (closest.empty() ? "" : "; did you mean '" + closest + "'?") +
                                " (there are: " + all + ")");
}

Outcome run_engine(const SearchRun& run, const Call& call) {
    if (call.component->composite != nullptr) return call.component->composite(run, call);
    Outcome outcome;
    try {
        Workshop workshop(run);
        SearchPlan plan = workshop.search_plan(call);
        const bool own_bound = plan.bound < run.bound;
        plan.bound = std::min(plan.bound, run.bound);
        plan.shared_bound = run.shared_bound;
        const Budget own = plan.max_time < 1e9 ? run.budget.within(plan.max_time) : run.budget;
        SearchContext context(run, plan, workshop.take_heuristics(), own);
        try {
            outcome.status =
                plan.expansion == Expansion::eager ? eager_search(context) : lazy_search(context);
            outcome.no_cheaper_plan = outcome.status == Status::unsolvable ||
                                      (outcome.status == Status::failed && context.complete && !own_bound &&
                                       plan.reopen_closed && plan.cost_type == CostType::normal);
        } catch (const std::bad_alloc&) {
            outcome.status = Status::out_of_memory;
        }
        if (context.best) {
            if (outcome.status == Status::failed) outcome.status = Status::solved;
            outcome.plan = std::move(context.best);
            outcome.cost = context.best_cost;
            outcome.optimal = plan.optimal || outcome.no_cheaper_plan;
        }
        context.monitor.finish(context.space, context.evaluator);
        outcome.statistics = context.monitor.statistics;
    } catch (const std::bad_alloc&) {
        outcome.status = Status::out_of_memory;
    }
    return outcome;
}

Outcome search(const PreparedTask& prepared, const Query& query, const Configuration& configuration,
               const Budget& budget, const SearchCallbacks& callbacks) {
    const Call call = check_expression(configuration.expression);
    check(prepared.task(), query);
    Outcome outcome;
    if (prepared.stop() != Stop::none) {
        outcome.status = status_of(prepared.stop());
        return outcome;
    }
    const FiniteDomainTask& task = prepared.task();
    if (task.proved_unsolvable && query.initial_values == task.initial_values && query.goal == task.goal) {
        outcome.status = Status::unsolvable_early;
        return outcome;
    }
    SharedParts shared;
    Incumbent incumbent;
    SearchCallbacks noting = callbacks;
    noting.on_plan = [&](std::span<const OperatorId> plan, std::int64_t cost) {
        if (incumbent.offer(plan, cost) && callbacks.on_plan) callbacks.on_plan(plan, cost);
    };
    outcome = run_engine({prepared, query, shared, incumbent, configuration.seed, configuration.threads,
                          budget, noting, kInfinity},
                         call);
    outcome.statistics.peak_memory = peak_memory();
    return outcome;
}

}  // namespace praxis
