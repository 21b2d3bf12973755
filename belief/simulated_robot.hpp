// A simulated world that speaks in names, as a robot does: also of objects that the agent has not found yet.
#pragma once

#include <memory>
#include <span>

#include "belief/atom_names.hpp"
#include "belief/simulated_world.hpp"

namespace praxis::belief {

class SimulatedRobot : public Skills, public Observer {
  public:
    /// `task` is the ground task with all objects; the world is one of its.
    SimulatedRobot(std::shared_ptr<const BeliefTask> task, SimulatedWorld& world);

    /// An action that the world does not have is illegal. Its actions have no parameters: any are passed
    /// over.
    Execution execute(const ActionName& action, std::span<const double> parameters,
                      std::stop_token stop) override;
    /// All that the world's sensors and the last action's readings tell.
    Percept observe(const ObservationRequest& request, std::stop_token stop) override;

  private:
    std::shared_ptr<const BeliefTask> task_;
    SimulatedWorld* world_;
    ActionNames actions_;
};

}  // namespace praxis::belief
