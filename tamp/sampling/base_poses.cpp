#include "tamp/sampling/base_poses.hpp"

#include <cmath>
#include <numbers>

namespace praxis::tamp {

namespace {

/// The angle within half a turn of `reference`.
double near_angle(double angle, double reference) {
    return reference + std::remainder(angle - reference, 2 * std::numbers::pi);
}

}  // namespace

std::vector<Configuration> make_base_poses(const Vector3& around, const Configuration& now,
                                           const BasePoseOptions& options) {
    std::vector<Configuration> poses;
    const double dx = now[0] - around.x();
    const double dy = now[1] - around.y();
    const double distance = std::hypot(dx, dy);
    if (distance >= options.nearest && distance <= options.furthest) poses.push_back(now);
    const double side = distance > 1e-9 ? std::atan2(dy, dx) : 0;
    constexpr int kRings = 3;
    const int turns = std::max(1, (options.count + kRings - 1) / kRings);
    for (int turn = 0; turn < turns; ++turn) {
        // 0, 1, -1, 2, -2, ... steps around.
        const int steps = turn % 2 == 1 ? (turn + 1) / 2 : -turn / 2;
        const double angle = side + 2 * std::numbers::pi * steps / turns;
        for (int ring = 0; ring < kRings && static_cast<int>(poses.size()) < options.count; ++ring) {
            // The middle ring first: there the arm is freest.
            const double share = ring == 0 ? 0.5 : ring == 1 ? 0.85 : 0.15;
            const double radius = options.nearest + share * (options.furthest - options.nearest);
            poses.push_back({around.x() + radius * std::cos(angle), around.y() + radius * std::sin(angle),
                             near_angle(angle + std::numbers::pi, now[2])});
        }
    }
    return poses;
}

}  // namespace praxis::tamp
