#include "practice/loop/skill_world.hpp"

#include <utility>

namespace praxis::practice {

ActionName name_of(const Description& description, const GroundSkill& skill) {
    ActionName name{{description.schemas[static_cast<std::size_t>(skill.schema)].name}};
    for (const std::int32_t object : skill.objects)
        name.words.push_back(description.objects[static_cast<std::size_t>(object)]);
    return name;
}

SkillWorld::SkillWorld(const Description& description, Skills& skills, See see, NextTask next_task,
                       std::stop_token stop)
    : description_(&description),
      skills_(&skills),
      see_(std::move(see)),
      next_task_(std::move(next_task)),
      stop_(std::move(stop)) {}

const State& SkillWorld::observe() {
    return state_ = see_();
}

void SkillWorld::execute(const GroundSkill& skill, std::span<const double> parameters) {
    last_ = skills_->execute(name_of(*description_, skill), parameters, stop_);
}

}  // namespace praxis::practice
