#include "tamp/solve/schedule.hpp"

#include "tamp/manipulation/manipulator_model.hpp"
#include "tamp/motion/time_parametrisation.hpp"
#include "tamp/report/describe.hpp"

namespace praxis::tamp {

namespace {

/// Of corners along straight motions of the hand (radians).
constexpr double kLineDeviation = 0.002;

class Schedule {
  public:
    Schedule(const Manipulator& manipulator, const World& world, const ScheduleOptions& options)
        : model_(manipulator.model()),
          options_(options),
          world_(world),
          configuration_(model_.home),
          document_(begin_document(*model_.robot, world, model_.home)) {
        for (const Group& group : model_.robot->groups) {
            limits_.push_back(motion_limits(*model_.robot, group, options.speed, options.acceleration));
        }
    }

    void add(const ScheduledAction& action) {
        const int number = static_cast<int>(document_.plan.size());
        const double start = time_;
        for (const MotionPiece& piece : action.motion.pieces) add(piece, number);
        document_.plan.push_back({action.name, action.arguments, start, time_});
    }

    TrajectoryDocument take() { return std::move(document_); }

  private:
    void add(const MotionPiece& piece, int action) {
        const Group& group = model_.group(piece.group);
        TrajectoryDocument::Segment segment{
            .action = action, .kind = piece.kind, .start = time_, .end = time_};
        if (piece.path.size() > 1) {
            const auto checker =
                model_.checker(std::make_shared<const World>(world_), piece.group, configuration_);
            const Trajectory trajectory =
                time_parametrise(piece.path, limits_[static_cast<std::size_t>(piece.group)],
                                 {.max_deviation = may_cut(piece) ? options_.max_deviation : kLineDeviation,
                                  .checker = checker.get(),
                                  .step = kCheckStep / 8});
            segment = describe_motion(group, trajectory, action, piece.kind, time_);
            model_.robot->insert(group, piece.path.back(), configuration_);
        }
        time_ = segment.end;
        if (piece.attach) {
            segment.attach = describe_hold(*model_.robot, world_, piece.attach->first, piece.attach->second);
            world_ = world_.with_attached(piece.attach->first, piece.attach->second);
        }
        if (piece.detach) {
            segment.detach = describe_stand(world_, piece.detach->first, piece.detach->second);
            world_ = world_.with_pose(piece.detach->first, piece.detach->second);
        }
        document_.segments.push_back(std::move(segment));
    }

    /// Lines along which the hand comes and goes stay nearly as they are.
    static bool may_cut(const MotionPiece& piece) {
        using Kind = TrajectoryDocument::Motion;
        return piece.kind == Kind::transit || piece.kind == Kind::transfer || piece.kind == Kind::base;
    }

    const ManipulatorModel& model_;
    const ScheduleOptions& options_;
    World world_;
    Configuration configuration_;
    TrajectoryDocument document_;
    std::vector<MotionLimits> limits_;  ///< by group
    double time_ = 0;
};

}  // namespace

TrajectoryDocument schedule(const Manipulator& manipulator, const World& world,
                            const std::vector<ScheduledAction>& actions, const ScheduleOptions& options) {
    Schedule schedule(manipulator, world, options);
    for (const ScheduledAction& action : actions) schedule.add(action);
    return schedule.take();
}

}  // namespace praxis::tamp
