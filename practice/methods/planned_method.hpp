// The part that all methods with plans share: tasks are pursued by plans of least cost.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "practice/methods/method.hpp"
#include "practice/methods/plan_follower.hpp"

namespace praxis::practice {

class PlannedMethod : public Method {
  public:
    explicit PlannedMethod(Learner& learner)
        : learner_(&learner),
          task_plan_(learner, learner.planner()),
          practice_plan_(learner, learner.planner()),
          test_plan_(learner, learner.test_planner()) {}

    void begin_task(const Situation& situation, bool test) override;
    std::optional<Decision> pursue(const Moment& now, const std::vector<Fact>& goal, Random& random,
                                   bool test) override;
    void begin_practice() override;
    void observe(const Moment& before, const Decision& decision, const Moment& after, bool success,
                 bool test) override;

  protected:
    /// A random skill of those that can be executed now, with parameters of the base sampler.
    std::optional<Decision> random_skill(const Moment& now) const;
    /// The next skill of doing the task again and again, with exploring parameters: back to what held at its
    /// beginning, then to its goal. A random skill where there is no plan.
    std::optional<Decision> repeat_task(const Moment& now);
    /// The tasks over which plans are costed.
    std::vector<Situation> situations() const;

    Learner* learner_;
    PlanFollower task_plan_;
    PlanFollower practice_plan_;
    PlanFollower test_plan_;

  private:
    Situation task_;
    bool back_ = true;  // `repeat_task` is on its way to the beginning
    std::vector<Situation> first_;
    std::deque<Situation> replans_;
};

}  // namespace praxis::practice
