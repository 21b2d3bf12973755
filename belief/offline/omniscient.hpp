// What a task costs for one who knows the true state.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "belief/belief_task.hpp"
#include "belief/worlds.hpp"
#include "search/engines/search.hpp"

namespace praxis::belief {

/// Optimal classical plans from true states. Prepared once.
class Omniscient {
  public:
    explicit Omniscient(std::shared_ptr<const BeliefTask> task, const Budget& budget = {});

    enum class Status : std::uint8_t { optimal, unsolvable, not_computed };
    struct Cost {
        Status status = Status::not_computed;
        double cost = 0;  ///< in the task's units
    };
    Cost cost(const WorldState& world, const Budget& budget = {}) const;

  private:
    std::shared_ptr<const BeliefTask> task_;
    PreparedTask prepared_;
    Configuration search_;
};

}  // namespace praxis::belief
