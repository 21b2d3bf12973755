#include "tamp/manipulation/manipulator.hpp"

#include <stdexcept>

#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/manipulation/skill_run.hpp"

namespace praxis::tamp {

struct Manipulator::Implementation : ManipulatorModel {
    using ManipulatorModel::ManipulatorModel;
};

Manipulator::Manipulator(std::shared_ptr<const Robot> robot, const std::string& effector,
                         const std::string& base_group, const Configuration& carry,
                         const ManipulatorOptions& options)
    : implementation_(
          std::make_unique<const Implementation>(std::move(robot), effector, base_group, carry, options)) {}
Manipulator::~Manipulator() = default;
Manipulator::Manipulator(Manipulator&&) noexcept = default;
Manipulator& Manipulator::operator=(Manipulator&&) noexcept = default;

const Robot& Manipulator::robot() const {
    return *implementation_->robot;
}

const EndEffector& Manipulator::effector() const {
    return implementation_->effector;
}

const ManipulatorOptions& Manipulator::options() const {
    return implementation_->options;
}

ActionResult Manipulator::pick(const RobotState& state, int body, const Grasp& grasp,
                               const Budget& budget) const {
    const BodyState& taken = (*state.world)[body];
    if (taken.attachment) throw std::invalid_argument("body '" + taken.model->name + "' is held already");
    return SkillRun(*implementation_, state, "pick '" + taken.model->name + "'", budget).pick(body, grasp);
}

ActionResult Manipulator::place(const RobotState& state, int body, const Grasp& grasp, const Pose& pose,
                                const Budget& budget) const {
    const BodyState& put = (*state.world)[body];
    if (!put.attachment) throw std::invalid_argument("body '" + put.model->name + "' is not held");
    return SkillRun(*implementation_, state, "place '" + put.model->name + "'", budget)
        .place(body, grasp, pose);
}

}  // namespace praxis::tamp
