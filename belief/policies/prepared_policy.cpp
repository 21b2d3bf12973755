#include "belief/policies/prepared_policy.hpp"

#include <utility>
#include <vector>

#include "belief/offline/optimal_policy.hpp"

namespace praxis::belief {

PreparedPolicy::PreparedPolicy(std::shared_ptr<const ConditionalPlan> plan) : plan_(std::move(plan)) {}

Decision PreparedPolicy::next(Belief&, const Budget&) {
    if (lost_ || plan_->goal(node_)) return {Decision::Kind::plan};
    return {Decision::Kind::act, plan_->action(node_)};
}

void PreparedPolicy::observed(std::span<const Answer> answers) {
    const bool first = !std::exchange(begun_, true);
    // A plan that does not depend on the first look begins with an action.
    if (lost_ || plan_->goal(node_) || (first && plan_->action(node_) != Environment::kStart)) return;
    std::vector<Fact> facts;
    for (const Answer& answer : answers) facts.push_back(answer.fact);
    const std::optional<std::uint32_t> next = plan_->next(node_, facts);
    lost_ = !next;
    if (next) node_ = *next;
}

std::shared_ptr<const ConditionalPlan> prepare_best(const std::shared_ptr<const BeliefTask>& task,
                                                    const Budget& budget) {
    OptimalPolicyOptions options;
    options.most_worlds = 1'000;
    options.most_states = 50'000;
    options.most_beliefs = 50'000;
    OptimalPolicy policy = optimal_policy(task, options, budget);
    if (policy.status != OptimalPolicy::Status::optimal) return nullptr;
    return std::make_shared<const ConditionalPlan>(std::move(policy.plan));
}

}  // namespace praxis::belief
