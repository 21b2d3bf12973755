#include "belief/offline/optimal_policy.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "belief/offline/belief_search.hpp"
#include "belief/offline/state_graph.hpp"
#include "belief/offline/state_table.hpp"

namespace praxis::belief {
namespace {

using Member = BeliefSearch::Member;

/// Adds up the parts into which the first readings divide the first states.
std::optional<std::int64_t> solve_parts(BeliefSearch& search, const std::vector<std::uint32_t>& parts,
                                        OptimalPolicyOptions::Criterion criterion) {
    std::int64_t total = 0;
    for (std::uint32_t part : parts) {
        const std::optional<std::int64_t> cost = search.solve(part);
        if (!cost || *cost >= StateGraph::kUnreachable) return cost;
        total = criterion == OptimalPolicyOptions::Criterion::expected_cost ? total + *cost
                                                                            : std::max(total, *cost);
    }
    return total;
}

void compute(const std::shared_ptr<const BeliefTask>& task, const OptimalPolicyOptions& options,
             const Budget& budget, OptimalPolicy& result) {
    StateTable table(task);
    std::vector<StateIndex> first;
    for (const WorldState& world : result.worlds) first.push_back(table.add(world));
    const std::optional<StateGraph> graph = StateGraph::explore(table, options.most_states, budget);
    if (!graph) {
        result.message = "too many states";
        return;
    }
    BeliefSearch search(*graph, *task->physical, options.criterion, options.most_beliefs, budget);
    std::map<std::vector<Fact>, std::vector<Member>> answered;
    for (StateIndex state : first)
        answered[table.observation(state, Environment::kStart)].push_back({state, 1});
    std::vector<std::uint32_t> parts;
    for (auto& [observation, members] : answered) parts.push_back(search.add(std::move(members)));
    const std::optional<std::int64_t> cost = solve_parts(search, parts, options.criterion);
    result.beliefs = search.beliefs();
    if (!cost) {
        result.message = "too many beliefs, or no time or memory left";
        return;
    }
    if (*cost >= StateGraph::kUnreachable) {
        result.status = OptimalPolicy::Status::unsolvable;
        return;
    }
    PlanDraft draft;
    std::vector<PlanDraft::Edge> edges;
    std::size_t next = 0;
    for (const auto& [observation, members] : answered)
        edges.push_back({observation, search.write(parts[next++], draft)});
    result.plan =
        draft.finish(edges.size() == 1 ? edges.front().target : draft.add(Environment::kStart, edges));
    const auto scale = static_cast<double>(task->physical->cost_scale);
    for (StateIndex state : first)
        result.omniscient.push_back(static_cast<double>(graph->distance(state)) / scale);
    std::optional<PlanCosts> costs = plan_costs(task, result.plan, result.worlds);
    if (!costs) throw std::logic_error("the optimal policy does not reach the goal in every world");
    result.costs = std::move(*costs);
    result.status = OptimalPolicy::Status::optimal;
}

}  // namespace

OptimalPolicy optimal_policy(const std::shared_ptr<const BeliefTask>& task, std::vector<WorldState> worlds,
                             const OptimalPolicyOptions& options, const Budget& budget) {
    const double start = processor_seconds();
    OptimalPolicy result;
    result.worlds = std::move(worlds);
    if (!certain_outcomes(*task)) {
        result.message = "actions with effects of chance, or readings with errors";
    } else if (task->physical->proved_unsolvable) {
        result.status = OptimalPolicy::Status::unsolvable;
    } else if (result.worlds.empty()) {
        result.message = "no first state";
    } else if (result.worlds.size() > options.most_worlds) {
        result.message = "too many first states";
    } else {
        compute(task, options, budget, result);
    }
    result.seconds = processor_seconds() - start;
    return result;
}

OptimalPolicy optimal_policy(const std::shared_ptr<const BeliefTask>& task,
                             const OptimalPolicyOptions& options, const Budget& budget) {
    if (task->physical->proved_unsolvable)
        return optimal_policy(task, std::vector<WorldState>(), options, budget);
    std::optional<std::vector<WorldState>> worlds = enumerate_worlds(*task, options.most_worlds);
    if (worlds) return optimal_policy(task, std::move(*worlds), options, budget);
    OptimalPolicy result;
    result.message = "too many first states";
    return result;
}

}  // namespace praxis::belief
