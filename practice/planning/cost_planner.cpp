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
    std::size_t looked_at = 0;     // nodes, to find ways with `costs`
};

/// A situation that occurs `weight` times.
struct CostPlanner::Case {
    GoalTable* goal;
    NodeIndex node;
    double weight;
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
constexpr std::size_t kSmallRegion = 1000;
constexpr std::size_t kLargestRegion = 8;  // this part of all states

}  // namespace

CostPlanner::CostPlanner(const SkillTask& skills, const CostPlannerOptions& options)
    : skills_(&skills), options_(options), graph_(skills, options.most_states) {
    if (options.threads < 1) throw std::invalid_argument("a planner needs at least one thread");
    configuration(options.search);
    for (int thread = 0; thread < options.threads; ++thread) {
        scratch_.emplace_back(graph_.graph());
        regions_.emplace_back(graph_.graph());
    }
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
        for (const SkillGraph::Edge& edge : graph_.graph().forward(node)) {
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
    if (!std::ranges::equal(goal.costs, costs)) {
        goal.costs.assign(costs.begin(), costs.end());
        goal.distances.clear();
        goal.looked_at = 0;
    }
    // Ways are cheap where goals are near; a table is worth it once they have cost as much as one.
    if (goal.looked_at > graph_.size()) update(goal, costs);
    if (!goal.distances.empty()) return descend(goal, node, costs);
    SkillPlan plan;
    const bool found = scratch_[0].way(node, goal.nodes, costs, plan.skills, plan.cost);
    goal.looked_at += scratch_[0].looked_at();
    if (!found) return std::nullopt;
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
    std::vector<Case> cases;
    for (std::size_t i = 0; i < situations.size(); ++i) {
        GoalTable& goal = table(situations[i].goal);
        const auto same =
            std::ranges::find_if(cases, [&](const Case& c) { return c.goal == &goal && c.node == start[i]; });
        if (same != cases.end())
            same->weight += 1;
        else
            cases.push_back({&goal, start[i], 1});
    }
    std::vector<double> sums(improvements.size() + 1, 0);  // the last: how many have a plan
    if (graph_.size() > options_.large) cases = add_by_regions(cases, costs, improvements, sums);
    add_by_tables(cases, costs, improvements, sums);
    const double solvable = sums.back();
    sums.pop_back();
    for (double& sum : sums) sum = solvable > 0 ? sum / solvable : std::numeric_limits<double>::infinity();
    return sums;
}

void CostPlanner::add_by_tables(std::span<const Case> cases, std::span<const Cost> costs,
                                std::span<const Improvement> improvements, std::span<double> sums) {
    std::vector<GoalTable*> goals;
    std::vector<std::vector<NodeIndex>> nodes;  // by goal
    std::vector<std::vector<double>> weights;
    for (const Case& one : cases) {
        const auto place = static_cast<std::size_t>(std::ranges::find(goals, one.goal) - goals.begin());
        if (place == goals.size()) {
            update(*one.goal, costs);
            goals.push_back(one.goal);
            nodes.emplace_back();
            weights.emplace_back();
        }
        if (one.goal->distances[one.node] == kNoPlan) continue;
        nodes[place].push_back(one.node);
        weights[place].push_back(one.weight);
        sums.back() += one.weight;
    }
    const auto sum_of = [&](int thread, const Improvement& improvement) {
        ShortestPaths& paths = scratch_[static_cast<std::size_t>(thread)];
        double sum = 0;
        std::vector<Cost> result;
        for (std::size_t g = 0; g < goals.size(); ++g) {
            result.resize(nodes[g].size());
            if (improvement.cost <= costs[improvement.skill]) {
                paths.cheaper(goals[g]->distances, costs, improvement.skill, improvement.cost, nodes[g],
                              result);
            } else {
                std::vector<Cost> changed(costs.begin(), costs.end());
                std::vector<Cost> distances;
                changed[improvement.skill] = improvement.cost;
                paths.to_goals(goals[g]->nodes, changed, distances);
                for (std::size_t i = 0; i < result.size(); ++i) result[i] = distances[nodes[g][i]];
            }
            for (std::size_t i = 0; i < result.size(); ++i) sum += weights[g][i] * nats(result[i]);
        }
        return sum;
    };
    const bool many = improvements.size() * goals.size() * graph_.graph().edge_count() > kWorthAThread;
    in_parallel(many ? options_.threads : 1, improvements.size(),
                [&](int thread, std::size_t i) { sums[i] += sum_of(thread, improvements[i]); });
}

/// Returns the cases whose regions are too large.
std::vector<CostPlanner::Case> CostPlanner::add_by_regions(std::span<const Case> cases,
                                                           std::span<const Cost> costs,
                                                           std::span<const Improvement> improvements,
                                                           std::span<double> sums) {
    std::vector<Cost> lower(costs.begin(), costs.end());
    for (const Improvement& improvement : improvements)
        lower[improvement.skill] = std::min(lower[improvement.skill], improvement.cost);
    std::vector<std::vector<double>> parts(cases.size());
    std::vector<unsigned char> too_large(cases.size(), 0);
    in_parallel(options_.threads, cases.size(), [&](int thread, std::size_t i) {
        Region& region = regions_[static_cast<std::size_t>(thread)];
        const std::vector<NodeIndex>& goals = cases[i].goal->nodes;
        if (region.begin(cases[i].node, goals, costs) == kNoPlan) return;
        too_large[i] =
            !region.make(goals, costs, lower, std::max(kSmallRegion, graph_.size() / kLargestRegion));
        if (too_large[i] != 0) return;
        for (const Improvement& improvement : improvements)
            parts[i].push_back(cases[i].weight * nats(region.improved(costs, goals, improvement)));
        parts[i].push_back(cases[i].weight);
    });
    for (const std::vector<double>& part : parts) {
        for (std::size_t i = 0; i < part.size(); ++i) sums[i] += part[i];
    }
    std::vector<Case> others;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (too_large[i] != 0) others.push_back(cases[i]);
    }
    return others;
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
