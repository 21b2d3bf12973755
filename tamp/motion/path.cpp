#include "tamp/motion/path.hpp"

#include <algorithm>
#include <cmath>

namespace praxis::tamp {

double path_length(const Path& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        double squared = 0;
        for (std::size_t j = 0; j < path[i].size(); ++j) {
            const double difference = path[i][j] - path[i - 1][j];
            squared += difference * difference;
        }
        length += std::sqrt(squared);
    }
    return length;
}

Configuration Trajectory::at(double time) const {
    if (knots.empty()) return {};
    const auto after = std::ranges::upper_bound(knots, time, {}, &Knot::time);
    if (after == knots.begin()) return knots.front().positions;
    const Knot& knot = *(after - 1);
    Configuration positions = knot.positions;
    if (after == knots.end()) return positions;
    const double elapsed = time - knot.time;
    for (std::size_t j = 0; j < positions.size(); ++j) {
        positions[j] += elapsed * (knot.velocities[j] + elapsed / 2 * knot.accelerations[j]);
    }
    return positions;
}

}  // namespace praxis::tamp
