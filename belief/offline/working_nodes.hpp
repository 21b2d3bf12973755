// Which finished parts of a conditional plan reach the goal from further states, and at what cost.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "belief/offline/conditional_plan.hpp"
#include "belief/offline/state_table.hpp"

namespace praxis::belief {

class WorkingNodes {
  public:
    /// Refers to its arguments.
    WorkingNodes(StateTable& table, const PlanDraft& draft) : table_(&table), draft_(&draft) {}

    /// What it costs to follow the plan from the node in the state; kFails if that does not reach the goal.
    std::int64_t cost(std::uint32_t node, StateIndex state);
    static constexpr std::int64_t kFails = -1;

    /// The node that works in all states and costs least; looks at the last kCandidates ones.
    std::optional<std::uint32_t> cheapest(std::span<const std::uint32_t> nodes,
                                          std::span<const StateIndex> states);
    static constexpr std::size_t kCandidates = 2'000;

  private:
    StateTable* table_;
    const PlanDraft* draft_;
    std::unordered_map<std::uint64_t, std::int64_t> costs_;
};

}  // namespace praxis::belief
