// The hidden worlds that `plan belief` acts in, one after the other.
#pragma once

#include <optional>
#include <vector>

#include "app/command_line.hpp"
#include "belief/worlds.hpp"

namespace praxis::app {

/// Those of files, evenly spread over all of them; or random ones. Where the first states can be counted,
/// all of them are equally likely.
class BeliefWorlds {
  public:
    /// Refers to the task. Throws std::invalid_argument if no first state satisfies the initial description.
    BeliefWorlds(const belief::BeliefTask& task, const BeliefOptions& options);

    std::size_t count() const { return count_; }
    /// World number `i`; to be called with 0, 1, ... in this order.
    belief::WorldState next(std::size_t i);

  private:
    const belief::BeliefTask& task_;
    bool drawn_;
    std::size_t count_;
    Random random_;
    std::optional<std::vector<belief::WorldState>> all_;  ///< if there are not too many
};

}  // namespace praxis::app
