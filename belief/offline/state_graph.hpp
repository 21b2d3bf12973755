// All true states that can be reached from some first states, with what actions do there and how far the goal
// is.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "belief/offline/state_table.hpp"
#include "search/budget.hpp"

namespace praxis::belief {

/// Immutable once made.
class StateGraph {
  public:
    struct Step {
        std::uint32_t action;
        StateIndex target;
        std::uint32_t observation;  ///< number of what is answered after it
    };
    static constexpr std::int64_t kUnreachable = std::numeric_limits<std::int64_t>::max() / 4;

    /// States after the table's own; nothing if there are more than `most` or the budget runs out.
    static std::optional<StateGraph> explore(StateTable& table, std::size_t most, const Budget& budget);

    std::size_t size() const { return goals_.size(); }
    /// By increasing action.
    std::span<const Step> steps(StateIndex state) const { return steps_[state]; }
    bool goal(StateIndex state) const { return goals_[state]; }
    /// Least cost from the state to the goal for one who knows the state.
    std::int64_t distance(StateIndex state) const { return distances_[state]; }
    const std::vector<Fact>& observation(std::uint32_t number) const { return observations_[number]; }

  private:
    StateGraph() = default;
    void compute_distances(const FiniteDomainTask& task);

    PackedLists<Step> steps_;  // by state
    std::vector<bool> goals_;
    std::vector<std::int64_t> distances_;
    std::vector<std::vector<Fact>> observations_;
};

}  // namespace praxis::belief
