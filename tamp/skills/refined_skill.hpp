// A step of a refined plan as a skill: an option (I, pi, beta, phi; see search/skills.hpp).
//
// Initiation: the robot is where the motion begins, and the bodies that are seen stand where they were when
// it was planned and checked; what the step's precondition says in words is the task's affair. Policy: where
// to be, and how fast, at each time. Termination: the time is up, and the gripper has done all that the step
// wants of it. Parameters: the continuous arguments, by their names; they are chosen, the motion is made of
// them.
//
// A skill begins and ends at rest, and is at rest whenever the gripper acts, so that it can be gone back from
// there. The plan is shared and never changes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tamp/report/replay.hpp"
#include "tamp/skills/robot_driver.hpp"

namespace praxis::tamp {

/// A plan and its motion, ready for look-ups. Refers to itself: shared, not copied.
class RefinedMotion {
  public:
    /// Throws std::invalid_argument as `check_document` does.
    explicit RefinedMotion(TrajectoryDocument document)
        : document_(std::move(document)), replay_(document_) {}
    RefinedMotion(const RefinedMotion&) = delete;
    RefinedMotion& operator=(const RefinedMotion&) = delete;

    const TrajectoryDocument& document() const { return document_; }
    const Replay& replay() const { return replay_; }

  private:
    TrajectoryDocument document_;
    Replay replay_;
};

/// How far measured things may be from planned ones.
struct SkillTolerance {
    double robot = 0.02;  ///< of a variable, radians or metres
    double body = 0.01;   ///< metres
    double turn = 0.1;    ///< of a body, radians; infinite where turns are not seen
};

class RefinedSkill {
  public:
    /// What the gripper does at a time: it takes a body, or lets it go.
    struct Event {
        double time = 0;  ///< from the start of the skill
        std::optional<TrajectoryDocument::Hold> attach = {};
        std::optional<TrajectoryDocument::Stand> detach = {};
    };
    /// The variable that is furthest from its place, and by how much.
    struct Deviation {
        std::size_t variable = 0;
        double amount = 0;
    };

    /// Throws std::invalid_argument if there is no such step, if another one moves at the same time, if the
    /// robot is not at rest at the start, at the end or when the gripper acts, or if this acts at the start.
    RefinedSkill(std::shared_ptr<const RefinedMotion> motion, std::size_t step);

    const std::string& name() const { return action().name; }
    const std::vector<std::string>& arguments() const { return action().arguments; }
    /// The continuous arguments that numbers are known of: poses, grasps, ...
    std::vector<std::pair<std::string, TrajectoryDocument::Value>> parameters() const;
    /// Whether the words name this skill; continuous arguments may be left out.
    bool is(const ActionName& words) const;

    /// Why the skill cannot start; nothing: it can. `positions` of the whole robot.
    std::optional<std::string> refusal(std::span<const double> positions, const BodyPoses& bodies,
                                       const SkillTolerance& tolerance = {}) const;
    /// The name of a variable of the robot.
    const std::string& variable(std::size_t number) const {
        return motion_->document().robot.variables[number];
    }
    /// Seconds.
    double duration() const { return duration_; }
    /// At a time from the start of the skill, within 0 and `duration()`.
    RobotCommand command(double time) const;
    /// In order of time.
    const std::vector<Event>& events() const { return events_; }
    /// Of measured positions at a time; throws std::invalid_argument if there are not as many as variables.
    /// Fingers count only where `fingers` is set: what they hold stops them.
    Deviation deviation(double time, std::span<const double> positions, bool fingers = false) const;

  private:
    const TrajectoryDocument::Action& action() const { return motion_->document().plan[step_]; }
    void check() const;

    std::shared_ptr<const RefinedMotion> motion_;
    std::size_t step_;
    double duration_ = 0;
    std::vector<Event> events_;
    std::vector<bool> finger_, turns_;  ///< by variable: of a gripper; an angle without limits
};

/// All steps of a plan.
std::vector<RefinedSkill> refined_skills(TrajectoryDocument document);

}  // namespace praxis::tamp
