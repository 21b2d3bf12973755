#include "practice/loop/practised_skills.hpp"

#include <utility>

namespace praxis::practice {

PractisedSkills::PractisedSkills(const Learner& learner, Skills& skills, SkillWorld::See see,
                                 std::uint64_t seed)
    : learner_(&learner), skills_(&skills), see_(std::move(see)), random_(seed) {
    const SkillTask& task = learner.skills();
    for (SkillIndex skill = 0; skill < task.size(); ++skill)
        if (!task.schema(skill).parameters.empty())
            practised_.emplace(name_of(task.environment().description(), task.skill(skill)), skill);
}

Execution PractisedSkills::execute(const ActionName& action, std::span<const double> parameters,
                                   std::stop_token stop) {
    const auto practised = practised_.find(action);
    if (practised == practised_.end() || !parameters.empty())
        return skills_->execute(action, parameters, std::move(stop));
    const Decision decision = learner_->decide(practised->second, see_(), Learner::Mode::greedy, random_);
    return skills_->execute(action, decision.parameters, std::move(stop));
}

}  // namespace praxis::practice
