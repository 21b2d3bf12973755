#include "app/belief_yardstick.hpp"

#include <utility>

#include "belief/offline/optimal_policy.hpp"

namespace praxis::app {
namespace {

/// Wall seconds for an optimal plan of one world.
constexpr double kOmniscientSeconds = 5;

}  // namespace

BeliefYardstick::BeliefYardstick(std::shared_ptr<const belief::BeliefTask> task, const Budget& budget)
    : task_(std::move(task)) {
    const belief::OptimalPolicy best = belief::optimal_policy(task_, {}, budget);
    switch (best.status) {
        case belief::OptimalPolicy::Status::optimal:
            for (std::size_t i = 0; i < best.worlds.size(); ++i)
                known_[best.worlds[i]] = {best.costs.costs[i], best.omniscient[i]};
            break;
        case belief::OptimalPolicy::Status::unsolvable:
            message_ = "no policy reaches the goal in all first states";
            break;
        case belief::OptimalPolicy::Status::not_computed:
            message_ = best.message;
            break;
    }
}

BeliefYardstick::Costs BeliefYardstick::costs(const belief::WorldState& world, const Budget& budget) {
    const auto found = known_.find(world);
    if (found != known_.end()) return found->second;
    Costs costs;
    if (too_hard_ || task_->physical->proved_unsolvable) return costs;
    if (!omniscient_) omniscient_ = std::make_unique<belief::Omniscient>(task_, budget);
    const belief::Omniscient::Cost cost = omniscient_->cost(world, budget.within(kOmniscientSeconds));
    too_hard_ = cost.status == belief::Omniscient::Status::not_computed;
    if (cost.status == belief::Omniscient::Status::optimal) costs.omniscient = cost.cost;
    known_[world] = costs;
    return costs;
}

}  // namespace praxis::app
