// Picking and placing: the skills of an arm with a parallel gripper, also on a mobile base.
//
// To pick, the robot goes with open fingers to a place before the body, approaches along the hand's axis,
// closes its fingers, and lifts the body. To place, it carries the body to a place above its pose, lowers it,
// opens its fingers, and draws the hand back. Of the many arm configurations for one grasp (and, with a
// mobile base, of the many base poses) a fixed number are tried, in a fixed order; the cheap tests come
// first, the motion planner last. A failure says which movable bodies stood in the way of all of them.
//
// A manipulator does not change once made; the calls are independent and equal calls have equal results.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "search/budget.hpp"
#include "tamp/manipulation/robot_state.hpp"
#include "tamp/sampling/grasps.hpp"

namespace praxis::tamp {

struct ManipulatorOptions {
    double approach = 0.1;       ///< metres along the hand's axis before and after the body is touched
    double lift = 0.05;          ///< metres that a body is lifted, if there is room
    double low_lift = 0.01;      ///< metres that it is lifted before it is drawn out where there is no room
    int arm_configurations = 6;  ///< tried for one grasp (and base pose)
    int base_poses = 24;         ///< tried for one grasp
    double base_nearest = 0.35;  ///< metres from the base to the body, at least and at most
    double base_furthest = 0.75;
    bool certified = true;   ///< motions are checked at four times the resolution (`motion/planner.hpp`)
    double plan_time = 0.5;  ///< seconds for one motion; then it counts as not found
    std::uint64_t seed = 0;
};

class Manipulator {
  public:
    /// `effector` is a name among the robot's end effectors (empty: the first). `base_group`: the group of a
    /// mobile base; empty: the arm stands. `carry`: positions of the arm while the base moves. Throws
    /// std::invalid_argument for names that are not there.
    Manipulator(std::shared_ptr<const Robot> robot, const std::string& effector,
                const std::string& base_group, const Configuration& carry,
                const ManipulatorOptions& options = {});
    ~Manipulator();
    Manipulator(Manipulator&&) noexcept;
    Manipulator& operator=(Manipulator&&) noexcept;

    const Robot& robot() const;
    const EndEffector& effector() const;
    const ManipulatorOptions& options() const;

    /// Takes `body` from where it stands.
    ActionResult pick(const RobotState& state, int body, const Grasp& grasp, const Budget& budget = {}) const;
    /// Puts the body, held by `grasp`, to `pose`.
    ActionResult place(const RobotState& state, int body, const Grasp& grasp, const Pose& pose,
                       const Budget& budget = {}) const;

  private:
    struct Implementation;
    std::unique_ptr<const Implementation> implementation_;
};

}  // namespace praxis::tamp
