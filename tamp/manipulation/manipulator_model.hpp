// What all calls of a manipulator share: groups, the inverse kinematics of the arm, how wide the fingers are.
#pragma once

#include "tamp/collision/fcl_checker.hpp"
#include "tamp/manipulation/manipulator.hpp"
#include "tamp/motion/inverse_kinematics.hpp"
#include "tamp/motion/planner.hpp"

namespace praxis::tamp {

struct ManipulatorModel {
    /// Throws std::invalid_argument, see `Manipulator`.
    ManipulatorModel(std::shared_ptr<const Robot> robot, Configuration home, const std::string& effector,
                     const std::string& base_group, const ManipulatorOptions& options);

    std::shared_ptr<const Robot> robot;
    EndEffector effector;
    ManipulatorOptions options;
    int arm;
    int base = -1;       ///< -1: the arm stands
    int gripper = -1;    ///< -1: no fingers that move
    Configuration home;  ///< of the whole robot; the fingers are open

    const Group& group(int index) const { return robot->groups[static_cast<std::size_t>(index)]; }
    /// A fast checker.
    std::unique_ptr<CollisionChecker> checker(WorldPointer world, int group, const Configuration& rest) const;
    const std::shared_ptr<SolidCache>& solids() const { return cache_; }
    /// Nothing of the arm is further away from its first joints.
    double reach_radius() const { return ik_.chain().reach().radius; }
    /// Positions of the fingers that are `opening` metres apart.
    Configuration fingers(double opening) const;
    /// How far apart the fingers are while they hold a body: a hair wider than it, since touching would count
    /// as a collision.
    static double grip(const Grasp& grasp);
    Attachment hold(const Grasp& grasp) const;
    Pose tool(const Configuration& configuration) const;

    /// Number `number` of the arm's configurations with the tool at `target`, wherever the base of
    /// `configuration` stands; the first is the one nearest to the arm's in it. Empty: there is none.
    std::optional<Configuration> reach(const Configuration& configuration, const Pose& target,
                                       std::uint64_t number) const;
    /// The arm's path that moves the tool from `arm` along straight lines, each by a vector in the world.
    std::optional<Path> straight(const Configuration& configuration, const Configuration& arm,
                                 std::span<const Vector3> legs) const;

    /// A motion from `start` to `goal`, whose ends are exactly these.
    MotionResult travel(CollisionChecker& checker, const Configuration& start, const Configuration& goal,
                        std::uint64_t variation, const Budget& budget,
                        int max_iterations = MotionOptions().max_iterations) const;

  private:
    /// Maps the world to what it is for the solver, whose base is at rest.
    Pose to_solver(const Configuration& configuration) const;

    /// The last joint of the arm: where the target puts it, and how far it can be.
    struct Wrist {
        Pose in_tool = Pose::Identity();
        KinematicChain::Reach reach = {};
    };
    std::optional<Wrist> find_wrist() const;
    bool is_out_of_reach(const Pose& target) const;

    int carrier_;  ///< link that the arm is mounted on
    Pose carrier_at_rest_;
    InverseKinematics ik_;
    std::optional<Wrist> wrist_;
    std::shared_ptr<SolidCache> cache_ = make_solid_cache();
};

}  // namespace praxis::tamp
