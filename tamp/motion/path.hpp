// Paths and trajectories of one group.
#pragma once

#include <span>
#include <vector>

#include "tamp/robots/robot.hpp"

namespace praxis::tamp {

/// Waypoints of a group, joined by straight segments; at least one. All have the group's dimension.
using Path = std::vector<Configuration>;

/// Sum of Euclidean lengths over the group's variables (radians and metres).
double path_length(const Path& path);

/// A path in time: it runs piecewise with constant acceleration of every variable. Positions between two
/// knots follow from position and velocity at the first and the accelerations of the piece.
struct Trajectory {
    struct Knot {
        double time = 0;  ///< seconds from the start; increasing
        Configuration positions;
        Configuration velocities;
        Configuration accelerations;  ///< until the next knot; zero at the last
    };
    std::vector<Knot> knots;

    double duration() const { return knots.empty() ? 0 : knots.back().time; }
    /// Positions at a time; before the start and after the end those of the ends.
    Configuration at(double time) const;
};

}  // namespace praxis::tamp
