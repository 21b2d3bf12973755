#include "belief/offline/plan_costs.hpp"

#include <algorithm>

#include "belief/offline/state_table.hpp"

namespace praxis::belief {

std::optional<PlanCosts> plan_costs(const std::shared_ptr<const BeliefTask>& task,
                                    const ConditionalPlan& plan, std::span<const WorldState> worlds) {
    if (plan.size() == 0) return std::nullopt;
    StateTable table(task);
    PlanCosts result;
    const auto scale = static_cast<double>(task->physical->cost_scale);
    for (const WorldState& world : worlds) {
        StateIndex state = table.add(world);
        std::int64_t cost = 0;
        std::size_t actions = 0;
        std::uint32_t node = 0;
        while (!plan.goal(node)) {
            const std::uint32_t action = plan.action(node);
            if (action != Environment::kStart) {
                if (!table.applicable(state, action)) return std::nullopt;
                state = table.successor(state, action);
                cost += task->physical->costs[action];
                ++actions;
            }
            const std::optional<std::uint32_t> next = plan.next(node, table.observation(state, action));
            if (!next) return std::nullopt;
            node = *next;
        }
        if (!table.goal(state)) return std::nullopt;
        result.costs.push_back(static_cast<double>(cost) / scale);
        result.mean += result.costs.back();
        result.worst = std::max(result.worst, result.costs.back());
        result.mean_actions += static_cast<double>(actions);
    }
    if (!worlds.empty()) {
        result.mean /= static_cast<double>(worlds.size());
        result.mean_actions /= static_cast<double>(worlds.size());
    }
    return result;
}

}  // namespace praxis::belief
