#include "tamp/manipulation/manipulator.hpp"

#include <map>
#include <mutex>

#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/manipulation/skill_run.hpp"

namespace praxis::tamp {

/// What is known of the fixed bodies that were seen last.
struct Manipulator::Memory {
    struct Key {
        std::string bytes;
    };
    std::mutex mutex;
    std::unique_ptr<SkillSpace> space;
    std::map<std::pair<SkillSpace::Id, SkillSpace::Id>, Site> sites;
};

Manipulator::Manipulator(std::shared_ptr<const Robot> robot, const Configuration& home,
                         const std::string& effector, const std::string& base_group,
                         const ManipulatorOptions& options)
    : model_(
          std::make_unique<const ManipulatorModel>(std::move(robot), home, effector, base_group, options)),
      memory_(std::make_unique<Memory>()) {}
Manipulator::~Manipulator() = default;
Manipulator::Manipulator(Manipulator&&) noexcept = default;
Manipulator& Manipulator::operator=(Manipulator&&) noexcept = default;

const Robot& Manipulator::robot() const {
    return *model_->robot;
}

const EndEffector& Manipulator::effector() const {
    return model_->effector;
}

const ManipulatorOptions& Manipulator::options() const {
    return model_->options;
}

ActionResult Manipulator::run(bool pick, const World& world, int body, const Pose& pose, const Grasp& grasp,
                              const Budget& budget, std::uint64_t variation) const {
    const std::lock_guard lock(memory_->mutex);
    if (!memory_->space || !memory_->space->matches(world)) {
        memory_->sites.clear();
        memory_->space = std::make_unique<SkillSpace>(*model_, world);
    }
    SkillSpace& space = *memory_->space;
    const std::pair key(space.standing(body, pose), space.held(body, grasp));
    Site& site = memory_->sites.try_emplace(key, space, body, pose, grasp).first->second;
    const auto skill = pick ? SkillRun::Skill::pick : SkillRun::Skill::place;
    return SkillRun(space, site, skill, world, body, pose, grasp, budget, variation).run();
}

ActionResult Manipulator::pick(const World& world, int body, const Grasp& grasp, const Budget& budget,
                               std::uint64_t variation) const {
    return run(true, world, body, world[body].pose, grasp, budget, variation);
}

ActionResult Manipulator::place(const World& world, int body, const Grasp& grasp, const Pose& pose,
                                const Budget& budget, std::uint64_t variation) const {
    return run(false, world, body, pose, grasp, budget, variation);
}

}  // namespace praxis::tamp
