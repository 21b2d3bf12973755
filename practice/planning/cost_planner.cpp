#include "practice/planning/cost_planner.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <thread>

namespace praxis::practice {

/// What is known about one goal.
struct CostPlanner::GoalTable {
    std::vector<Fact> goal;
    std::size_t states = 0;        // of the graph when `nodes` was made
    std::vector<NodeIndex> nodes;  // where the goal holds
    std::vector<Cost> costs;       // those of the last question
    std::vector<Cost> distances;   // by node for `costs`, or empty
};

namespace {

/// The situations of one goal: each node once, and how often.
struct Group {
    std::vector<NodeIndex> nodes;
    std::vector<double> weights;
};

double weighted(const Group& group, std::span<const Cost> distances) {
    double sum = 0;
    for (std::size_t i = 0; i < group.nodes.size(); ++i) {
        if (distances[i] != kNoPlan) sum += group.weights[i] * nats(distances[i]);
    }
    return sum;
}

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

}  // namespace

CostPlanner::CostPlanner(const SkillTask& skills, const CostPlannerOptions& options)
    : skills_(&skills), options_(options), graph_(skills, options.most_states) {
    if (options.threads < 1) throw std::invalid_argument("a planner needs at least one thread");
    configuration(options.search);
    for (int thread = 0; thread < options.threads; ++thread) scratch_.emplace_back(graph_);
}

CostPlanner::~CostPlanner() = default;

CostPlanner::GoalTable& CostPlanner::table(const std::vector<Fact>& goal) {
    GoalTable* found = nullptr;
    for (const auto& table : tables_) {
        if (table->goal == goal) found = table.get();
    }
    if (found == nullptr) {
        found = tables_.emplace_back(std::make_unique<GoalTable>()).get();
        found->goal = goal;
    }
    if (found->states != graph_.size()) {
        found->states = graph_.size();
        found->nodes = graph_.where(goal);
        found->distances.clear();
    }
    return *found;
}

void CostPlanner::update(GoalTable& table, std::span<const Cost> costs) {
    if (!table.distances.empty() && std::ranges::equal(table.costs, costs)) return;
    table.costs.assign(costs.begin(), costs.end());
    scratch_[0].to_goals(table.nodes, costs, table.distances);
}

std::optional<SkillPlan> CostPlanner::descend(const GoalTable& table, NodeIndex node,
                                              std::span<const Cost> costs) const {
    if (table.distances[node] == kNoPlan) return std::nullopt;
    SkillPlan plan{{}, table.distances[node]};
    while (table.distances[node] > 0) {
        for (const StateGraph::Edge& edge : graph_.forward(node)) {
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
    NodeIndex node = 0;
    if (!graph_.reach(situation.values, node)) return search(situation, costs);
    GoalTable& goal = table(situation.goal);
    const bool again = std::ranges::equal(goal.costs, costs);
    if (again) {
        update(goal, costs);
        return descend(goal, node, costs);
    }
    goal.costs.assign(costs.begin(), costs.end());
    goal.distances.clear();
    SkillPlan plan;
    if (!scratch_[0].way(node, goal.nodes, costs, plan.skills, plan.cost)) return std::nullopt;
    return plan;
}

std::vector<double> CostPlanner::expected_costs(std::span<const Situation> situations,
                                                std::span<const Cost> costs,
                                                std::span<const Improvement> improvements) {
    if (costs.size() != skills_->size()) throw std::invalid_argument("one cost a skill is needed");
    std::vector<NodeIndex> start(situations.size());
    for (std::size_t i = 0; i < situations.size(); ++i) {
        if (!graph_.reach(situations[i].values, start[i]))
            return search_costs(situations, costs, improvements);
    }
    std::vector<GoalTable*> goals;
    std::vector<Group> groups;
    double solvable = 0;
    for (std::size_t i = 0; i < situations.size(); ++i) {
        GoalTable& goal = table(situations[i].goal);
        const auto known = static_cast<std::size_t>(std::ranges::find(goals, &goal) - goals.begin());
        if (known == goals.size()) {
            update(goal, costs);
            goals.push_back(&goal);
            groups.emplace_back();
        }
        if (goal.distances[start[i]] == kNoPlan) continue;
        solvable += 1;
        Group& group = groups[known];
        const auto place =
            static_cast<std::size_t>(std::ranges::find(group.nodes, start[i]) - group.nodes.begin());
        if (place == group.nodes.size()) {
            group.nodes.push_back(start[i]);
            group.weights.push_back(0);
        }
        group.weights[place] += 1;
    }
    if (solvable == 0)
        return std::vector<double>(improvements.size(), std::numeric_limits<double>::infinity());

    const auto sum_of = [&](int thread, const Improvement& improvement) {
        ShortestPaths& paths = scratch_[static_cast<std::size_t>(thread)];
        double sum = 0;
        std::vector<Cost> result;
        for (std::size_t g = 0; g < goals.size(); ++g) {
            const Group& group = groups[g];
            result.resize(group.nodes.size());
            if (improvement.cost <= costs[improvement.skill]) {
                paths.cheaper(goals[g]->distances, costs, improvement.skill, improvement.cost, group.nodes,
                              result);
            } else {
                std::vector<Cost> changed(costs.begin(), costs.end());
                std::vector<Cost> distances;
                changed[improvement.skill] = improvement.cost;
                paths.to_goals(goals[g]->nodes, changed, distances);
                for (std::size_t i = 0; i < result.size(); ++i) result[i] = distances[group.nodes[i]];
            }
            sum += weighted(group, result);
        }
        return sum / solvable;
    };
    std::vector<double> means(improvements.size());
    const bool many = improvements.size() * goals.size() * graph_.edge_count() > kWorthAThread;
    in_parallel(many ? options_.threads : 1, improvements.size(),
                [&](int thread, std::size_t i) { means[i] = sum_of(thread, improvements[i]); });
    return means;
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
