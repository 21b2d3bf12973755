// A simulated world: the true state, which only readings tell about.
//
// It executes the physical task's operators (it never learns which outcome a plan hoped for), answers the
// readings of actions and of all sensors whose condition truly holds, and lies with a given probability. Its
// skills fail with a given probability.
#pragma once

#include <memory>
#include <vector>

#include "belief/environment.hpp"
#include "belief/worlds.hpp"
#include "search/state/axiom_evaluator.hpp"

namespace praxis::belief {

class SimulatedWorld : public Environment {
  public:
    /// Starts in `state`. `noise`: the probability, 0 to 0.5, that an answer is the wrong one, each by
    /// itself. `failures`: the probability, 0 to 1, that an action fails; it happens all the same in half of
    /// these cases, and nothing happens in the others. Throws std::invalid_argument.
    SimulatedWorld(std::shared_ptr<const BeliefTask> task, WorldState state, double noise = 0,
                   std::uint64_t seed = 0, double failures = 0);

    /// An action whose precondition does not hold is illegal and changes nothing. One that fails reads
    /// nothing.
    Execution execute(std::uint32_t action, std::stop_token stop = {}) override;
    std::vector<Answer> observe(std::uint32_t action, std::stop_token stop = {}) override;

    /// The goal holds, whatever anybody believes.
    bool goal_holds() const { return all_hold(task_->physical->goal, state_.data()); }
    bool applicable(std::uint32_t action) const {
        return all_hold(task_->physical->preconditions[action], state_.data());
    }
    const WorldState& state() const { return state_; }
    /// The actions that have truly happened, in order.
    const std::vector<std::uint32_t>& happened() const { return happened_; }
    std::size_t failed() const { return failed_; }  ///< how many actions failed
    /// The states right after each of the actions that left something open, in order.
    const std::vector<WorldState>& after_chance() const { return after_chance_; }

  private:
    void apply(std::uint32_t action);
    void complete();
    /// Draws anew what the action leaves open.
    void forget(std::uint32_t action);
    void answer(const GroundReading& reading, std::vector<Answer>& answers);

    std::shared_ptr<const BeliefTask> task_;
    AxiomEvaluator axioms_;
    AxiomEvaluator::Scratch scratch_;
    WorldState state_;
    WorldState before_;
    std::vector<std::uint32_t> happened_;
    std::vector<WorldState> after_chance_;
    std::size_t failed_ = 0;
    bool reads_ = true;  ///< the last action did not fail
    double noise_, failures_;
    Random random_;
};

}  // namespace praxis::belief
