#include "practice/methods/other_methods.hpp"

namespace praxis::practice {

void TaskRepeatMethod::begin_practice() {
    PlannedMethod::begin_practice();
    back_ = true;
}

std::optional<Decision> TaskRepeatMethod::practise(const Moment& now) {
    for (int turn = 0; turn < 2; ++turn) {
        std::vector<Fact> goal = task().goal;
        if (back_) {
            goal.clear();
            for (std::size_t i = 0; i < task().values.size(); ++i) {
                const auto variable = static_cast<std::int32_t>(i);
                if (!learner_->skills().task().derived(variable))
                    goal.push_back({variable, task().values[i]});
            }
        }
        const std::optional<SkillIndex> skill = practice_plan_.next(now.values, goal);
        if (skill) return learner_->decide(*skill, now.state, Learner::Mode::explore, learner_->random());
        back_ = !back_;
    }
    return random_skill(now);
}

}  // namespace praxis::practice
