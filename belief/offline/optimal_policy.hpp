// The exact contingent optimum: a policy of least expected cost, if all first states are equally likely, or
// of least cost in the worst of them.
//
// Beliefs are sets of true states with the number of first states that led to each. As actions have no
// effects of chance, a belief never comes to stand for more first states: actions either keep all together,
// or what is read splits them. So the AND/OR search is done in levels: from each belief, A* over the actions
// that keep it together, to the cheapest *exit*: the goal, or an action whose reading splits, and then the
// same in each part. Searches of parts are resumed only as far as needed to tell whether an exit is still the
// cheapest. Admissible estimate: what each world would cost for one who knows it (computed backwards over all
// states).
//
// It grows fast: for small tasks, as a yardstick. Everything beyond the limits is "not computed".
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "belief/offline/conditional_plan.hpp"
#include "belief/offline/plan_costs.hpp"
#include "belief/worlds.hpp"
#include "search/budget.hpp"

namespace praxis::belief {

struct OptimalPolicyOptions {
    enum class Criterion : std::uint8_t { expected_cost, worst_cost };
    Criterion criterion = Criterion::expected_cost;
    std::size_t most_worlds = 5'000;
    std::size_t most_states = 500'000;
    std::size_t most_beliefs = 2'000'000;
};

struct OptimalPolicy {
    enum class Status : std::uint8_t {
        optimal,
        unsolvable,    ///< no plan reaches the goal in all first states
        not_computed,  ///< beyond the limits; `message` says which
    };
    Status status = Status::not_computed;
    std::string message;
    std::vector<WorldState> worlds;  ///< the first states
    /// optimal: the policy. Among policies that are equally good, any.
    ConditionalPlan plan;
    /// optimal: what it costs in `worlds`, in the task's units of cost.
    PlanCosts costs;
    /// optimal: by world, the cost of an optimal plan of one who knows the world.
    std::vector<double> omniscient;
    std::size_t beliefs = 0;
    double seconds = 0;  ///< processor time
};

/// From all first states that the initial description allows.
OptimalPolicy optimal_policy(const std::shared_ptr<const BeliefTask>& task,
                             const OptimalPolicyOptions& options = {}, const Budget& budget = {});

/// From these first states.
OptimalPolicy optimal_policy(const std::shared_ptr<const BeliefTask>& task, std::vector<WorldState> worlds,
                             const OptimalPolicyOptions& options = {}, const Budget& budget = {});

}  // namespace praxis::belief
