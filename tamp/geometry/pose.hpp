// Rigid transformations. Lengths are metres, angles radians; a pose of B in A maps coordinates of B to those
// of A. Frames are right-handed; z is up in the world.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>

namespace praxis::tamp {

using Vector3 = Eigen::Vector3d;
using Pose = Eigen::Isometry3d;

/// At `position`, turned by roll about x, then pitch about y, then yaw about z (all fixed axes, as in URDF).
Pose pose_from_rpy(const Vector3& position, const Vector3& roll_pitch_yaw);

/// At `position`, turned by the quaternion (x, y, z, w), which is normalised here. Throws
/// std::invalid_argument if it is not finite or has length zero.
Pose pose_from_quaternion(const Vector3& position, const std::array<double, 4>& xyzw);

/// A pose as seven numbers: x y z, then the quaternion qx qy qz qw with qw >= 0. Files use this form.
std::array<double, 7> to_numbers(const Pose& pose);
/// The inverse of `to_numbers`. Throws std::invalid_argument as `pose_from_quaternion` does.
Pose pose_from_numbers(std::span<const double, 7> numbers);

/// Every entry is finite.
bool is_finite(const Pose& pose);

}  // namespace praxis::tamp
