#include "practice/planning/cost_planner.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include "practice/planning/relevance.hpp"

namespace praxis::practice {

struct CostPlanner::Scratch {
    explicit Scratch(const StateGraph& graph) : paths(graph), improved(graph) {}
    ShortestPaths paths;
    ImprovedPaths improved;
};

/// The states of all goals for which the same variables matter.
struct CostPlanner::Space {
    Space(const SkillTask& skills, std::vector<unsigned char> the_relevant, const CostPlannerOptions& options)
        : relevant(std::move(the_relevant)), graph(skills, relevant, options.most_states) {
        for (int thread = 0; thread < options.threads; ++thread) scratch.emplace_back(graph);
    }
    std::vector<unsigned char> relevant;  // by variable
    StateGraph graph;
    Projections projections{graph};
    std::vector<Scratch> scratch;  // by thread
};

/// What is known about one goal.
struct CostPlanner::GoalTable {
    std::vector<Fact> goal;
    Space* space = nullptr;
    std::size_t states = 0;        // of the graph when `nodes` was made
    std::vector<NodeIndex> nodes;  // where the goal holds
    std::vector<Cost> costs;       // those of the last question
    std::vector<Cost> distances;   // by node for `costs`, or empty
    std::size_t looked_at = 0;     // nodes, to find ways with `costs`
};

namespace {

/// Calls work(thread, i) for all i below `count`.
template <class Work>
void in_parallel(int threads, std::size_t count, Work&& work) {
    const auto run = [&](int thread) {
        for (std::size_t i = static_cast<std::size_t>(thread); i < count;
             i += static_cast<std::size_t>(threads))
            work(thread, i);
    };
    std::vector<std::jthread> others;
    for (int thread = 1; thread < threads; ++thread) others.emplace_back(run, thread);
    run(0);
}

constexpr std::size_t kWorthAThread = 200'000;  // edges that the threads may have to look at

std::vector<Cost> least_costs(std::span<const Cost> costs, std::span<const Improvement> improvements) {
    std::vector<Cost> least(costs.begin(), costs.end());
    for (const auto [skill, cost] : improvements) least[skill] = std::min(least[skill], cost);
    return least;
}

}  // namespace

CostPlanner::CostPlanner(const SkillTask& skills, const CostPlannerOptions& options)
    : skills_(&skills), options_(options) {
    if (options.threads < 1) throw std::invalid_argument("a planner needs at least one thread");
    configuration(options.search);
}

CostPlanner::~CostPlanner() = default;

std::size_t CostPlanner::states() const {
    std::size_t sum = 0;
    for (const auto& space : spaces_) sum += space->graph.size();
    return sum;
}

void CostPlanner::forget() {
    if (tables_.size() <= kMostGoals) return;
    tables_.resize(kMostGoals);
    std::erase_if(spaces_, [&](const auto& space) {
        return std::ranges::none_of(tables_, [&](const auto& table) { return table->space == space.get(); });
    });
}

CostPlanner::GoalTable& CostPlanner::table(const std::vector<Fact>& goal) {
    auto found = std::ranges::find_if(tables_, [&](const auto& table) { return table->goal == goal; });
    if (found == tables_.end()) {
        auto made = std::make_unique<GoalTable>();
        made->goal = goal;
        made->space = &space(goal);
        found = tables_.insert(tables_.end(), std::move(made));
    }
    std::rotate(tables_.begin(), found, std::next(found));
    return *tables_.front();
}

CostPlanner::Space& CostPlanner::space(const std::vector<Fact>& goal) {
    std::vector<unsigned char> relevant = relevant_variables(skills_->task(), goal);
    for (const auto& space : spaces_) {
        if (space->relevant == relevant) return *space;
    }
    return *spaces_.emplace_back(std::make_unique<Space>(*skills_, std::move(relevant), options_));
}

bool CostPlanner::reach(GoalTable& table, const std::vector<std::int32_t>& values, NodeIndex& node) {
    StateGraph& graph = table.space->graph;
    if (!graph.reach(values, node)) return false;
    refresh(table);
    return true;
}

void CostPlanner::refresh(GoalTable& table) {
    const StateGraph& graph = table.space->graph;
    if (table.states == graph.size()) return;
    table.states = graph.size();
    table.nodes = graph.where(table.goal);
    table.distances.clear();
}

void CostPlanner::update(GoalTable& table, std::span<const Cost> costs) {
    if (!table.distances.empty() && std::ranges::equal(table.costs, costs)) return;
    table.costs.assign(costs.begin(), costs.end());
    table.space->scratch[0].paths.to_goals(table.nodes, costs, table.distances);
}

std::optional<SkillPlan> CostPlanner::descend(const GoalTable& table, NodeIndex node,
                                              std::span<const Cost> costs) {
    if (table.distances[node] == kNoPlan) return std::nullopt;
    SkillPlan plan{{}, table.distances[node]};
    while (table.distances[node] > 0) {
        for (const StateGraph::Edge& edge : table.space->graph.forward(node)) {
            if (table.distances[edge.node] == kNoPlan ||
                table.distances[edge.node] + costs[edge.skill] != table.distances[node])
                continue;
            plan.skills.push_back(edge.skill);
            node = edge.node;
            break;
        }
    }
    return plan;
}

std::optional<SkillPlan> CostPlanner::plan(const Situation& situation, std::span<const Cost> costs) {
    if (costs.size() != skills_->size()) throw std::invalid_argument("one cost a skill is needed");
    forget();
    GoalTable& goal = table(situation.goal);
    NodeIndex node = 0;
    if (!reach(goal, situation.values, node)) return search(situation, costs);
    if (!std::ranges::equal(goal.costs, costs)) {
        goal.costs.assign(costs.begin(), costs.end());
        goal.distances.clear();
        goal.looked_at = 0;
    }
    // Ways are cheap where goals are near; a table is worth it once they have cost as much as one.
    if (goal.looked_at > goal.states) update(goal, costs);
    if (!goal.distances.empty()) return descend(goal, node, costs);
    SkillPlan plan;
    ShortestPaths& paths = goal.space->scratch[0].paths;
    const bool found = paths.way(node, goal.nodes, costs, plan.skills, plan.cost);
    goal.looked_at += paths.looked_at();
    if (!found) return std::nullopt;
    return plan;
}

std::vector<double> CostPlanner::expected_costs(std::span<const Situation> situations,
                                                std::span<const Cost> costs,
                                                std::span<const Improvement> improvements) {
    if (costs.size() != skills_->size()) throw std::invalid_argument("one cost a skill is needed");
    forget();
    std::vector<Task> tasks;
    for (const Situation& situation : situations) {
        GoalTable& goal = table(situation.goal);
        NodeIndex node = 0;
        if (!reach(goal, situation.values, node)) return search_costs(situations, costs, improvements);
        const auto same = std::ranges::find_if(
            tasks, [&](const Task& task) { return task.from == node && task.goal == &goal; });
        if (same != tasks.end())
            same->weight += 1;
        else
            tasks.push_back({node, &goal, 1, {}});
    }
    // Later situations may have made a graph larger.
    const std::vector<Cost> least = least_costs(costs, improvements);
    std::size_t edges = 0;
    for (Task& task : tasks) {
        refresh(*task.goal);
        task.bound = GoalBound(skills_->task(), task.goal->space->projections, task.goal->goal, least);
        edges += improvements.size() * task.goal->space->graph.edge_count();
    }
    const int threads = edges > kWorthAThread ? options_.threads : 1;
    // One row a task, so that the sum does not depend on the threads.
    const std::size_t width = improvements.size();
    std::vector<double> rows(tasks.size() * width, 0);
    std::vector<unsigned char> solvable(tasks.size());
    in_parallel(threads, tasks.size(), [&](int thread, std::size_t i) {
        solvable[i] = weigh(tasks[i].goal->space->scratch[static_cast<std::size_t>(thread)], tasks[i],
                            {costs, least, improvements}, std::span(rows).subspan(i * width, width));
    });
    std::vector<double> means(width, 0);
    double weight = 0;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (!solvable[i]) continue;
        weight += tasks[i].weight;
        for (std::size_t j = 0; j < width; ++j) means[j] += rows[i * width + j];
    }
    for (double& mean : means) mean = weight > 0 ? mean / weight : std::numeric_limits<double>::infinity();
    return means;
}

bool CostPlanner::weigh(Scratch& scratch, const Task& task, const Question& question,
                        std::span<double> result) {
    const auto& [costs, least, improvements] = question;
    std::vector<SkillIndex> plan;
    Cost plan_cost = 0;
    if (!scratch.paths.way(task.from, task.goal->nodes, costs, plan, plan_cost)) return false;
    scratch.improved.begin(task.from, task.goal->nodes, costs, least, task.bound, plan, plan_cost);
    for (std::size_t i = 0; i < improvements.size(); ++i) {
        const auto [skill, cost] = improvements[i];
        Cost improved = plan_cost;
        if (cost <= costs[skill]) {
            improved = scratch.improved.cost(improvements[i]);
        } else if (std::ranges::find(plan, skill) != plan.end()) {
            std::vector<Cost> changed(costs.begin(), costs.end());
            changed[skill] = cost;
            std::vector<SkillIndex> other;
            scratch.paths.way(task.from, task.goal->nodes, changed, other, improved);
        }
        result[i] = task.weight * nats(improved);
    }
    return true;
}

std::optional<SkillPlan> CostPlanner::search(const Situation& situation, std::span<const Cost> costs) const {
    FiniteDomainTask task = skills_->task();
    task.unit_cost = false;
    for (std::size_t i = 0; i < costs.size(); ++i) task.costs[i] = static_cast<std::int32_t>(costs[i] >> 20);
    const PreparedTask prepared(std::make_shared<const FiniteDomainTask>(std::move(task)));
    Query query{situation.values, situation.goal};
    for (std::size_t i = 0; i < query.initial_values.size(); ++i) {
        if (skills_->task().derived(static_cast<std::int32_t>(i)))
            query.initial_values[i] = skills_->task().initial_values[i];
    }
    const Outcome outcome = praxis::search(prepared, query, configuration(options_.search),
                                           Budget().limit_wall_time(options_.search_seconds));
    if (!outcome.plan) return std::nullopt;
    SkillPlan plan;
    for (OperatorId id : *outcome.plan) {
        plan.skills.push_back(static_cast<SkillIndex>(id.index()));
        plan.cost += costs[id.index()];
    }
    return plan;
}

std::vector<double> CostPlanner::search_costs(std::span<const Situation> situations,
                                              std::span<const Cost> costs,
                                              std::span<const Improvement> improvements) const {
    std::vector<double> sums(improvements.size(), 0);
    double solvable = 0;
    std::vector<Cost> changed(costs.begin(), costs.end());
    for (const Situation& situation : situations) {
        const std::optional<SkillPlan> plan = search(situation, costs);
        if (!plan) continue;
        solvable += 1;
        for (std::size_t i = 0; i < improvements.size(); ++i) {
            const auto [skill, cost] = improvements[i];
            changed[skill] = cost;
            const std::optional<SkillPlan> other = cost == costs[skill] ? plan : search(situation, changed);
            changed[skill] = costs[skill];
            Cost with_plan = 0;
            for (SkillIndex used : plan->skills) with_plan += used == skill ? cost : costs[used];
            sums[i] += nats(other ? std::min(other->cost, with_plan) : with_plan);
        }
    }
    for (double& sum : sums) sum = solvable > 0 ? sum / solvable : std::numeric_limits<double>::infinity();
    return sums;
}

}  // namespace praxis::practice
