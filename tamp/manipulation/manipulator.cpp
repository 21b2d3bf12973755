#include "tamp/manipulation/manipulator.hpp"

#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/manipulation/skill_run.hpp"

namespace praxis::tamp {

Manipulator::Manipulator(std::shared_ptr<const Robot> robot, const Configuration& home,
                         const std::string& effector, const std::string& base_group,
                         const ManipulatorOptions& options)
    : model_(
          std::make_unique<const ManipulatorModel>(std::move(robot), home, effector, base_group, options)) {}
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

ActionResult Manipulator::pick(const World& world, int body, const Grasp& grasp, const Budget& budget,
                               std::uint64_t variation) const {
    const std::string what = "pick '" + world[body].model->name + "'";
    return SkillRun(*model_, std::make_shared<const World>(world), what, budget, variation).pick(body, grasp);
}

ActionResult Manipulator::place(const World& world, int body, const Grasp& grasp, const Pose& pose,
                                const Budget& budget, std::uint64_t variation) const {
    const std::string what = "place '" + world[body].model->name + "'";
    const auto holding = std::make_shared<const World>(world.with_attached(body, model_->hold(grasp)));
    return SkillRun(*model_, holding, what, budget, variation).place(body, grasp, pose);
}

}  // namespace praxis::tamp
