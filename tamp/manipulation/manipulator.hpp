// Picking and placing: the skills of an arm with a parallel gripper, also on a mobile base.
//
// To pick, the robot goes with open fingers to a place before the body, approaches along the hand's axis,
// closes its fingers, and lifts the body. To place, it carries the body to a place above its pose, lowers it,
// opens its fingers, and draws the hand back. Of the many arm configurations for one grasp (and, with a
// mobile base, of the many base poses) a fixed number are tried, in a fixed order; the cheap tests come
// first, the motion planner last. A failure says which movable bodies stood in the way of all of them.
//
// Every skill begins and ends at the home configuration. So whether one can be done depends on what stands
// where, and on nothing that was done before: failures can be learned from, and motions can be kept.
// `join_motions` (join.hpp) takes the ways home out of a finished plan.
//
// What was found out about the fixed bodies, and about movable bodies one by one, is kept for the next calls:
// a manipulator is fast where many worlds differ in few bodies. Equal calls have equal results; threads may
// share it, and take turns.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "search/budget.hpp"
#include "tamp/manipulation/action_motion.hpp"
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

struct ManipulatorModel;

class Manipulator {
  public:
    /// `effector` is a name among the robot's end effectors (empty: the first), `base_group` the group of a
    /// mobile base (empty: the arm stands), `home` a configuration of the whole robot. Throws
    /// std::invalid_argument for names that are not there and a home that is none.
    Manipulator(std::shared_ptr<const Robot> robot, const Configuration& home,
                const std::string& effector = {}, const std::string& base_group = {},
                const ManipulatorOptions& options = {});
    ~Manipulator();
    Manipulator(Manipulator&&) noexcept;
    Manipulator& operator=(Manipulator&&) noexcept;

    const Robot& robot() const;
    const EndEffector& effector() const;
    const ManipulatorOptions& options() const;
    const ManipulatorModel& model() const { return *model_; }

    /// Takes `body` from where it stands in the world. `variation` gives other motions.
    ActionResult pick(const World& world, int body, const Grasp& grasp, const Budget& budget = {},
                      std::uint64_t variation = 0) const;
    /// Puts the body, held by `grasp`, to `pose`; where it stands in `world` means nothing.
    ActionResult place(const World& world, int body, const Grasp& grasp, const Pose& pose,
                       const Budget& budget = {}, std::uint64_t variation = 0) const;

  private:
    struct Memory;
    ActionResult run(bool pick, const World& world, int body, const Pose& pose, const Grasp& grasp,
                     const Budget& budget, std::uint64_t variation) const;

    std::unique_ptr<const ManipulatorModel> model_;
    std::unique_ptr<Memory> memory_;
};

}  // namespace praxis::tamp
