// What tests of robots share.
#pragma once

#include <cmath>
#include <string>

#include "parser/diagnostic.hpp"
#include "search/engines/random.hpp"
#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

inline double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random.next() >> 11) * 0x1p-53;
}

/// Within the limits; unlimited variables within 3.
inline Configuration random_configuration(const Robot& robot, Random& random) {
    Configuration q;
    for (const Variable& variable : robot.variables) {
        q.push_back(uniform(random, std::isfinite(variable.lower) ? variable.lower : -3,
                            std::isfinite(variable.upper) ? variable.upper : 3));
    }
    return q;
}

/// The distance between the balls of two links: negative where they overlap.
inline double clearance(const Robot& robot, std::span<const Pose> poses, int first, int second) {
    const auto index = [](int link) { return static_cast<std::size_t>(link); };
    const Pose relative = poses[index(first)].inverse() * poses[index(second)];
    double nearest = std::numeric_limits<double>::infinity();
    for (const Ball& ball : robot.links[index(second)].balls) {
        const Vector3 center = relative * ball.center;
        for (const Ball& other : robot.links[index(first)].balls) {
            nearest = std::min(nearest, (other.center - center).norm() - other.radius - ball.radius);
        }
    }
    return nearest;
}

/// The message of the InputError that `act` throws.
template <class Act>
std::string input_error(Act act) {
    try {
        act();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace praxis::tamp
