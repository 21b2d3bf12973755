#include "practice/methods/planned_method.hpp"

namespace praxis::practice {

void PlannedMethod::begin_task(const Situation& situation, bool test) {
    if (test) {
        test_plan_.forget();
        return;
    }
    task_plan_.forget();
    task_ = situation;
    if (first_.size() < static_cast<std::size_t>(learner_->options().situations)) first_.push_back(situation);
}

void PlannedMethod::begin_practice() {
    practice_plan_.forget();
    back_ = true;
}

std::optional<Decision> PlannedMethod::pursue(const Moment& now, const std::vector<Fact>& goal,
                                              Random& random, bool test) {
    PlanFollower& plan = test ? test_plan_ : task_plan_;
    const std::optional<SkillIndex> skill = plan.next(now.values, goal);
    if (plan.replanned() && !test) {
        replans_.push_back({now.values, goal});
        if (replans_.size() > static_cast<std::size_t>(learner_->options().replans)) replans_.pop_front();
    }
    if (!skill) return std::nullopt;
    return learner_->decide(*skill, now.state, Learner::Mode::greedy, random);
}

void PlannedMethod::observe(const Moment&, const Decision&, const Moment&, bool success, bool test) {
    if (test) {
        test_plan_.observe(success);
        return;
    }
    task_plan_.observe(success);
    practice_plan_.observe(success);
}

std::optional<Decision> PlannedMethod::random_skill(const Moment& now) const {
    std::vector<SkillIndex> applicable;
    learner_->skills().for_each_applicable(now.values, [&](SkillIndex i) { applicable.push_back(i); });
    if (applicable.empty()) return std::nullopt;
    const SkillIndex skill = applicable[learner_->random().below(applicable.size())];
    return learner_->decide(skill, now.state, Learner::Mode::base, learner_->random());
}

std::optional<Decision> PlannedMethod::repeat_task(const Moment& now) {
    for (int turn = 0; turn < 2; ++turn) {
        std::vector<Fact> goal = task_.goal;
        if (back_) {
            goal.clear();
            for (std::size_t i = 0; i < task_.values.size(); ++i) {
                const auto variable = static_cast<std::int32_t>(i);
                if (!learner_->skills().task().derived(variable)) goal.push_back({variable, task_.values[i]});
            }
        }
        const std::optional<SkillIndex> skill = practice_plan_.next(now.values, goal);
        if (skill) return learner_->decide(*skill, now.state, Learner::Mode::explore, learner_->random());
        back_ = !back_;
    }
    return random_skill(now);
}

std::vector<Situation> PlannedMethod::situations() const {
    std::vector<Situation> all = first_;
    all.insert(all.end(), replans_.begin(), replans_.end());
    return all;
}

}  // namespace praxis::practice
