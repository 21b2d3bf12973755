// MAPLE-Q: no plans and no competences; skills and parameters are chosen by a learned value function.
//
// In task time and free time the robot pursues the task's goal, with probability `epsilon` by a random skill
// with random parameters, else by the action of highest value; the reward is 1 where the goal is reached.
// Once the goal holds, random skills lead away from it. Baseline of Kumar et al., RSS 2024, after Nasiriany
// et al., ICRA 2022.
#pragma once

#include <optional>
#include <vector>

#include "practice/methods/method.hpp"
#include "practice/policies/q_function.hpp"

namespace praxis::practice {

class MapleQMethod : public Method {
  public:
    explicit MapleQMethod(Learner& learner);

    void begin_task(const Situation& situation, bool test) override;
    std::optional<Decision> pursue(const Moment& now, const std::vector<Fact>& goal, Random& random,
                                   bool test) override;
    void begin_practice() override {}
    std::optional<Decision> practise(const Moment& now) override;
    void observe(const Moment& before, const Decision& decision, const Moment& after, bool success,
                 bool test) override;
    void learned() override;

  private:
    /// Numbers of the state, then by variable what the goal wants of it.
    std::vector<double> features(const State& state, const std::vector<Fact>& goal) const;
    /// What can be executed, with sampled parameters.
    std::vector<QFunction::Action> actions(const Moment& now, Random& random) const;
    std::optional<Decision> best(const Moment& now, const std::vector<Fact>& goal, Random& random) const;

    Learner* learner_;
    std::vector<Fact> goal_;
    std::optional<QFunction> values_;  // made when the size of states is known
};

}  // namespace praxis::practice
