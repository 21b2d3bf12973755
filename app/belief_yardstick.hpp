// What runs of `plan belief` are compared with: the best contingent policy, and one who knows the world.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "belief/offline/omniscient.hpp"
#include "belief/worlds.hpp"

namespace praxis::app {

class BeliefYardstick {
  public:
    /// Computes the policy of least expected cost, all first states being equally likely.
    BeliefYardstick(std::shared_ptr<const belief::BeliefTask> task, const Budget& budget);

    struct Costs {
        std::optional<double> policy;      ///< of that policy in this world
        std::optional<double> omniscient;  ///< of an optimal plan for this world
    };
    /// In the task's units of cost. Nothing where it could not be computed.
    Costs costs(const belief::WorldState& world, const Budget& budget);

    /// Why there is no policy to compare with; empty if there is one.
    const std::string& message() const { return message_; }

  private:
    std::shared_ptr<const belief::BeliefTask> task_;
    std::map<belief::WorldState, Costs> known_;
    std::string message_;
    /// Beyond what the policy's computation has found out; null as long as it is not needed.
    std::unique_ptr<belief::Omniscient> omniscient_;
    bool too_hard_ = false;  ///< one optimal plan was; the others are not tried
};

}  // namespace praxis::app
