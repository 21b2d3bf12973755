#include "tamp/geometry/pose.hpp"

#include <cmath>
#include <stdexcept>

namespace praxis::tamp {

Pose pose_from_rpy(const Vector3& position, const Vector3& roll_pitch_yaw) {
    Pose pose = Pose::Identity();
    pose.translation() = position;
    pose.linear() = (Eigen::AngleAxisd(roll_pitch_yaw.z(), Vector3::UnitZ()) *
                     Eigen::AngleAxisd(roll_pitch_yaw.y(), Vector3::UnitY()) *
                     Eigen::AngleAxisd(roll_pitch_yaw.x(), Vector3::UnitX()))
                        .toRotationMatrix();
    return pose;
}

Pose pose_from_quaternion(const Vector3& position, const std::array<double, 4>& xyzw) {
    Eigen::Quaterniond rotation(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    const double length = rotation.norm();
    if (!position.allFinite() || !std::isfinite(length) || length < 1e-9) {
        throw std::invalid_argument("a pose needs finite numbers and a quaternion that is not zero");
    }
    rotation.coeffs() /= length;
    Pose pose = Pose::Identity();
    pose.translation() = position;
    pose.linear() = rotation.toRotationMatrix();
    return pose;
}

std::array<double, 7> to_numbers(const Pose& pose) {
    Eigen::Quaterniond rotation(pose.linear());
    rotation.normalize();
    if (rotation.w() < 0) rotation.coeffs() = -rotation.coeffs();
    const Vector3 position = pose.translation();
    return {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z(), rotation.w()};
}

Pose pose_from_numbers(std::span<const double, 7> numbers) {
    return pose_from_quaternion({numbers[0], numbers[1], numbers[2]},
                                {numbers[3], numbers[4], numbers[5], numbers[6]});
}

bool is_finite(const Pose& pose) {
    return pose.matrix().allFinite();
}

}  // namespace praxis::tamp
