// The robot's skills as a world to practise in.
//
// What is left to say is how the state is seen and where tasks come from:
//
//     SkillWorld world(environment.description(), robot, [&] { return seen(); }, [&] { return next_goal();
//     }); PracticeLoop loop(environment, world, options);
#pragma once

#include <functional>
#include <stop_token>

#include "practice/environment.hpp"
#include "search/skills.hpp"

namespace praxis::practice {

/// A ground skill by the names of its schema and objects.
ActionName name_of(const Description& description, const GroundSkill& skill);

class SkillWorld : public World {
  public:
    using See = std::function<State()>;
    using NextTask = std::function<std::vector<GroundAtom>()>;

    /// Refers to the description and the skills. `stop` is handed on to every skill.
    SkillWorld(const Description& description, Skills& skills, See see, NextTask next_task,
               std::stop_token stop = {});

    std::vector<GroundAtom> next_task() override { return next_task_(); }
    const State& observe() override;
    /// What the robot says of it is no evidence: the state that is seen afterwards decides.
    void execute(const GroundSkill& skill, std::span<const double> parameters) override;

    /// How the last skill ended, as the robot says.
    const Execution& last() const { return last_; }

  private:
    const Description* description_;
    Skills* skills_;
    See see_;
    NextTask next_task_;
    std::stop_token stop_;
    State state_;
    Execution last_;
};

}  // namespace praxis::practice
