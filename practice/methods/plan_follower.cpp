#include "practice/methods/plan_follower.hpp"

namespace praxis::practice {

std::optional<SkillIndex> PlanFollower::next(const std::vector<std::int32_t>& values,
                                             const std::vector<Fact>& goal) {
    const bool same = goal == goal_;
    replanned_ = false;
    if (all_hold(goal, values.data())) {
        valid_ = false;
        return std::nullopt;
    }
    if (!same || !valid_ || place_ == plan_.size() || !learner_->skills().applicable(plan_[place_], values)) {
        replanned_ = same && place_ > 0;
        goal_ = goal;
        place_ = 0;
        plan_.clear();
        std::optional<SkillPlan> plan = planner_->plan({values, goal}, learner_->costs());
        valid_ = plan.has_value();
        if (!plan) return std::nullopt;
        plan_ = std::move(plan->skills);
    }
    return plan_[place_++];
}

}  // namespace praxis::practice
