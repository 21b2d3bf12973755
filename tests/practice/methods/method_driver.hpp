// A learner and a method by name on a small environment, with outcomes that a test writes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/practice/support/runs.hpp"
#include "tests/practice/support/tokens.hpp"

namespace praxis::practice::test {

class MethodDriver {
  public:
    /// Places and edges are those of `Tokens`; `goal` is over its predicates and objects.
    MethodDriver(int tokens, int places, const Tokens::Edges& edges, std::vector<GroundAtom> goal,
                 const PracticeOptions& options)
        : environment_(tokens, places, edges),
          learner_(environment_, options),
          method_(make_method(options.method, learner_)) {
        Random random(1);
        state = environment_.sample_task(random).initial;
        goal_ = learner_.skills().goal(goal);
    }

    Learner& learner() { return learner_; }
    Method& method() { return *method_; }
    const std::vector<Fact>& goal() const { return goal_; }
    Moment now() const { return learner_.moment(state); }

    void begin_task() { method_->begin_task({now().values, goal_}, false); }

    /// As if the skill had been executed so often somewhere where it can be, without success but for the
    /// first ones.
    void tell(const std::string& name, int successes, int failures) {
        const SkillIndex skill = learner_.skills().find(name);
        const GroundSkill& ground = learner_.skills().skill(skill);
        const auto token = static_cast<std::size_t>(ground.objects[0]);
        const auto tokens = (state.size() - 1) / 2;
        State before = state;
        before[tokens + token] = 0;
        before[token] = ground.objects[1] - static_cast<double>(tokens);
        State after = before;
        std::vector<double> parameters(learner_.skills().schema(skill).parameters.size(), state.back());
        Random random(1);
        environment_.execute(after, ground, parameters, random);
        for (int i = 0; i < successes + failures; ++i) {
            const Moment then = learner_.moment(i < successes ? after : before);
            learner_.observe(learner_.moment(before), {skill, parameters, true}, then);
        }
    }

    /// The candidates at the first choice of free time, best first.
    PracticeChoice first_choice() {
        begin_task();
        method_->begin_practice();
        method_->practise(now());
        return method_->take_choices().at(0);
    }

    /// Executes a decision; moves succeed, marking does with the right parameter.
    void execute(const Decision& decision) {
        const Moment before = now();
        Random random(1);
        environment_.execute(state, learner_.skills().skill(decision.skill), decision.parameters, random);
        const Moment after = now();
        const bool success = learner_.observe(before, decision, after);
        method_->observe(before, decision, after, success, false);
    }

    State state;

  private:
    Tokens environment_;
    Learner learner_;
    std::unique_ptr<Method> method_;
    std::vector<Fact> goal_;
};

/// Options with which scores can be computed by hand: Beta(1, 1), predictions half a unit higher.
inline PracticeOptions by_hand(const std::string& method) {
    PracticeOptions options = quick(method);
    options.competence.prior = {1, 1};
    options.competence.bonus = 0.5;
    options.bonus = 0.1;
    return options;
}

}  // namespace praxis::practice::test
