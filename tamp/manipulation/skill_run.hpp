// One call of a skill: tries the ways to do it, one after the other, and keeps the pieces of motion of the
// one that works.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tamp/manipulation/failure_log.hpp"
#include "tamp/manipulation/manipulator_model.hpp"

namespace praxis::tamp {

class SkillRun {
  public:
    SkillRun(const ManipulatorModel& model, WorldPointer world, std::string what, const Budget& budget,
             std::uint64_t variation)
        : model_(model),
          budget_(budget),
          variation_(variation),
          log_(std::move(what), model.effector.links),
          state_{model.home, std::move(world)} {}

    ActionResult pick(int body, const Grasp& grasp);
    ActionResult place(int body, const Grasp& grasp, const Pose& pose);

  private:
    using Kind = TrajectoryDocument::Motion;

    struct State {
        Configuration configuration;  ///< of the whole robot
        WorldPointer world;
    };

    /// Calls `attempt` where the robot is or, with a mobile base, from one base pose after the other.
    template <class Attempt>
    ActionResult from_base_poses(const Vector3& around, Attempt&& attempt);
    bool pick_from_here(int body, const Grasp& grasp);
    bool place_from_here(int body, const Grasp& grasp, const Pose& pose);
    bool pick_with(int body, const Grasp& grasp, const Configuration& arm);
    bool place_with(int body, const Grasp& grasp, const Pose& pose, const Configuration& arm);
    /// Brings the arm home.
    bool fold(Kind kind);

    void add(Kind kind, int group, Path path);
    void move_fingers(double opening);
    void set_world(World world) { state_.world = std::make_shared<const World>(std::move(world)); }
    bool travel(CollisionChecker& checker, Kind kind, int group, const Configuration& goal,
                const std::string& phase, bool homing);
    /// A path along straight lines that is free, the first of several; none: the reasons are logged.
    std::optional<Path> free_line(CollisionChecker& checker, const Configuration& arm,
                                  const std::vector<std::vector<Vector3>>& ways, const std::string& phase);
    std::vector<std::vector<Vector3>> ways_up(const Vector3& approach) const;
    bool out_of_budget();

    /// Bookkeeping of a way that fails: false.
    bool refuse(CollisionChecker& checker, const Configuration& positions, const std::string& phase);

    const ManipulatorModel& model_;
    const Budget& budget_;
    std::uint64_t variation_;
    FailureLog log_;
    State state_;
    std::vector<MotionPiece> pieces_;
    /// The hand itself, at its target, touches something: other positions of the arm do not help.
    bool hopeless_ = false;
};

}  // namespace praxis::tamp
