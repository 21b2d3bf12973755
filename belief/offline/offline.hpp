// Conditional plans beforehand, all in one call: made, checked in every first state that can be looked at,
// counted.
//
// A few ways to make the plan are tried while there is time (different searches, nodes shared more or less),
// and the plan that is cheapest on average is kept; for tasks small enough, the exact optimum is the plan. A
// plan that fails in a simulated world is never given out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "belief/knowledge_planner.hpp"
#include "belief/offline/conditional_plan.hpp"
#include "belief/offline/plan_costs.hpp"

namespace praxis::belief {

struct OfflineOptions {
    /// The only search to plan with; nothing: the ways above, those of `default_agent_options` first.
    std::optional<Configuration> search;
    /// More first states are not counted: the plan is then made without, and checked in `samples` of them.
    std::size_t most_worlds = 20'000;
    std::size_t samples = 1'000;
    std::uint64_t seed = 0;
    /// Only one way is tried after a plan is found and this time (wall) has passed.
    double improve_seconds = 10;
    /// The exact optimum is tried for this long; 0: not at all.
    double optimum_seconds = 5;
    /// Which of several plans is best; among equals, the one of fewer nodes.
    enum class Prefer : std::uint8_t { mean_cost, worst_cost, fewest_nodes };
    Prefer prefer = Prefer::mean_cost;
};

enum class OfflineStatus : std::uint8_t {
    found,
    unsolvable,   ///< proved: no plan reaches the goal in all first states
    not_found,    ///< none was found, without a proof
    limit,        ///< time or memory
    unsupported,  ///< actions with effects of chance, or readings with errors: no plan can be sure
};
const char* to_string(OfflineStatus status);

struct OfflineResult {
    OfflineStatus status = OfflineStatus::not_found;
    std::string message;
    ConditionalPlan plan;     ///< found
    PlanCosts costs;          ///< found: in the worlds that were looked at
    std::size_t checked = 0;  ///< worlds in which the plan was executed
    bool all_worlds = false;  ///< these are all first states
    bool optimal = false;     ///< no plan costs less (in the mean; with worst_cost, in the worst world)
    std::string way;          ///< which way made the plan
    std::size_t plans = 0;    ///< classical plans that were made
    double seconds = 0;       ///< processor time
};

OfflineResult plan_offline(const KnowledgePlanner& planner, const OfflineOptions& options = {},
                           const Budget& budget = {});

}  // namespace praxis::belief
