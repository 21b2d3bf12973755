// What readers of robots may be told beside the files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tamp/geometry/cover.hpp"

namespace praxis::tamp {

/// Limits of variables, by their names: radians or metres, a second, and a second squared.
struct MotionLimits {
    std::map<std::string, std::pair<double, double>> position = {};  ///< lower, upper
    std::map<std::string, double> velocity = {};
    std::map<std::string, double> acceleration = {};
};

/// Where a robot's file says nothing: a velocity of 1 a second, and an acceleration that reaches the velocity
/// in half a second.
inline constexpr double kDefaultVelocity = 1;
inline constexpr double kDefaultAccelerationTime = 0.5;

struct RobotOptions {
    /// Where `package://NAME/PATH` is looked for: as DIRECTORY/NAME/PATH, and as DIRECTORY/PATH if the
    /// directory's own name is NAME. Then the directories above the robot's file are tried in the same way.
    std::vector<std::string> packages = {};
    /// Override what the robot's file says.
    MotionLimits limits = {};
    CoverOptions cover = {};
    /// Shapes for pictures are read too. Such meshes may be missing: collision shapes are shown instead.
    bool visuals = true;
    /// Of the configurations that tell which pairs of links need no checks, where no file does.
    std::uint64_t seed = 1;
    std::size_t samples = 3000;
};

}  // namespace praxis::tamp
