// Where everything of a trajectory document is at a time.
#pragma once

#include <span>
#include <vector>

#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// Positions, velocities and accelerations of the whole robot. Where nothing moves, velocities and
/// accelerations are zero.
struct RobotMotion {
    Configuration positions;
    Configuration velocities;
    Configuration accelerations;
};

/// Answers in time logarithmic in the number of segments and knots. Keeps the document by reference.
class Replay {
  public:
    /// Throws std::invalid_argument as `check_document` does.
    explicit Replay(const TrajectoryDocument& document);

    /// At a time; before the start and after the end as at those. At a knot the accelerations are those of
    /// the piece that begins there.
    RobotMotion motion_at(double time) const;
    /// Names of the bodies that the robot holds, in order of the document. What happens at a segment's end
    /// has happened at its `end`.
    std::vector<std::string> held_at(double time) const;
    /// Poses of all links in the world.
    std::vector<Pose> links_at(double time) const;
    /// Poses of all bodies in the world.
    std::vector<Pose> bodies_at(double time) const;

  private:
    /// A segment that moves a variable, and which of its columns does.
    struct Piece {
        const TrajectoryDocument::Segment* segment = nullptr;
        std::size_t column = 0;
    };
    /// From `time` on, `hold` (or `stand`) says where a body is; neither: as at time 0.
    struct Change {
        double time = 0;
        const TrajectoryDocument::Hold* hold = nullptr;
        const TrajectoryDocument::Stand* stand = nullptr;
    };
    const Change& last_change(std::size_t body, double time) const;

    const TrajectoryDocument& document_;
    std::vector<std::vector<Piece>> pieces_;    ///< by variable, in order of time
    std::vector<std::vector<Change>> changes_;  ///< by body, in order of time; the first from the beginning
};

/// Poses of the links of a document's robot.
std::vector<Pose> link_poses(const TrajectoryDocument::Robot& robot, std::span<const double> configuration);

}  // namespace praxis::tamp
