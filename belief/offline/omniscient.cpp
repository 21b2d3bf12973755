#include "belief/offline/omniscient.hpp"

#include <utility>

namespace praxis::belief {

Omniscient::Omniscient(std::shared_ptr<const BeliefTask> task, const Budget& budget)
    : task_(std::move(task)), prepared_(task_->physical, budget), search_(configuration("astar(lmcut())")) {}

Omniscient::Cost Omniscient::cost(const WorldState& world, const Budget& budget) const {
    const FiniteDomainTask& physical = *task_->physical;
    Query query{world, physical.goal};
    for (std::size_t v = 0; v < query.initial_values.size(); ++v)
        if (physical.derived(static_cast<std::int32_t>(v)))
            query.initial_values[v] = physical.initial_values[v];
    const Outcome outcome = search(prepared_, query, search_, budget);
    Cost result;
    if (outcome.plan && outcome.optimal) {
        result.status = Status::optimal;
        result.cost = static_cast<double>(outcome.cost) / static_cast<double>(physical.cost_scale);
    } else if (outcome.status == praxis::Status::unsolvable ||
               outcome.status == praxis::Status::unsolvable_early) {
        result.status = Status::unsolvable;
    }
    return result;
}

}  // namespace praxis::belief
