#include "belief/simulated_robot.hpp"

#include <utility>

namespace praxis::belief {

SimulatedRobot::SimulatedRobot(std::shared_ptr<const BeliefTask> task, SimulatedWorld& world)
    : task_(std::move(task)), world_(&world), actions_(*task_->physical) {}

Execution SimulatedRobot::execute(const ActionName& action, std::span<const double> /*parameters*/,
                                  std::stop_token stop) {
    if (const auto id = actions_.action(action)) return world_->execute(*id, stop);
    return {Execution::Status::illegal, "there is no such action in the world"};
}

Percept SimulatedRobot::observe(const ObservationRequest& request, std::stop_token stop) {
    std::uint32_t action = Environment::kStart;
    if (request.action != nullptr) {
        const auto id = actions_.action(*request.action);
        if (!id) return {};
        action = *id;
    }
    Percept percept;
    const FiniteDomainTask& physical = *task_->physical;
    for (const Answer& answer : world_->observe(action, stop)) {
        const bool holds = physical.is_atom(answer.fact);
        const Fact atom = holds ? answer.fact : Fact{answer.fact.variable, 1 - answer.fact.value};
        percept.readings.push_back({AtomNames::name(physical, atom),
                                    holds ? Truth::known_true : Truth::known_false, answer.accuracy});
    }
    return percept;
}

}  // namespace praxis::belief
