// The joints between the world and one frame of a robot, laid out for inverse kinematics.
//
// Joints that the group does not move are folded into the fixed transforms between those it moves, and every
// frame is turned so that its joint's axis is z. Variables are numbered as in the group ("columns"); one that
// moves no joint of the chain has a zero column. Plain arrays of fixed size: nothing is allocated.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

inline constexpr std::size_t kMaxColumns = 16;

/// Orientation (the columns are the frame's axes) and origin of a frame.
struct Frame {
    std::array<double, 3> x = {1, 0, 0};
    std::array<double, 3> y = {0, 1, 0};
    std::array<double, 3> z = {0, 0, 1};
    std::array<double, 3> origin = {0, 0, 0};
};

Frame to_frame(const Pose& pose);
Pose to_pose(const Frame& frame);

/// How the frame moves with each column: velocity of its origin and angular velocity, in the world.
struct Jacobian {
    std::array<std::array<double, 3>, kMaxColumns> linear;
    std::array<std::array<double, 3>, kMaxColumns> angular;
};

class KinematicChain {
  public:
    /// The frame `tool` in `link`, moved by `group`; the robot's other variables stay at `rest`. Throws
    /// std::invalid_argument for numbers out of range, a `rest` or `tool` that is not finite or of the wrong
    /// size, and a link that the group does not move.
    KinematicChain(const Robot& robot, int group, int link, const Pose& tool, std::span<const double> rest);

    std::size_t columns() const { return columns_; }
    Frame forward(const double* positions) const;
    Frame forward(const double* positions, Jacobian& jacobian) const;

    /// The frame's origin is never further than `radius` from `center`, whatever the positions within the
    /// limits; infinite if a sliding joint has none.
    struct Reach {
        std::array<double, 3> center;
        double radius;
    };
    const Reach& reach() const { return reach_; }

  private:
    struct Link {
        Frame fixed;  ///< from the previous joint's frame (moved) to this one's
        bool slides = false;
        std::size_t column = 0;
        double multiplier = 1;
        double offset = 0;
    };
    template <bool kWithJacobian>
    Frame run(const double* positions, Jacobian* jacobian) const;

    std::vector<Link> links_;
    Frame tail_;
    std::size_t columns_ = 0;
    Reach reach_ = {};
};

}  // namespace praxis::tamp
