#include "tamp/sampling/placements.hpp"

#include <array>
#include <cmath>

#include "tamp/geometry/extent.hpp"

namespace praxis::tamp {

namespace {

double halton(std::uint32_t index, std::uint32_t base) {
    double result = 0;
    double share = 1;
    while (index > 0) {
        share /= base;
        result += share * (index % base);
        index /= base;
    }
    return result;
}

/// The middle, then the corners, then the middles of the sides; in [-1, 1].
constexpr std::array<std::array<double, 2>, 9> kGrid = {
    {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

}  // namespace

std::optional<Pose> make_placement(const BodyModel& body, const World& world, const Area& area,
                                   std::uint32_t number, const PlacementOptions& options) {
    if (number >= options.count || options.yaws.empty()) return std::nullopt;
    const auto turns = static_cast<std::uint32_t>(options.yaws.size());
    const std::uint32_t places = (options.count + turns - 1) / turns;
    const double yaw = options.yaws[number / places];
    const Pose turned = pose_from_rpy(Vector3::Zero(), {0, 0, yaw});
    if (body.shapes.empty()) return std::nullopt;
    const AxisBox box = extent(body.shapes, turned);
    const double room_x = (area.size[0] - box.size().x()) / 2 - options.margin;
    const double room_y = (area.size[1] - box.size().y()) / 2 - options.margin;
    if (room_x < 0 || room_y < 0) return std::nullopt;
    const std::uint32_t place = number % places;
    std::array<double, 2> share;
    if (options.grid && place < kGrid.size()) {
        share = kGrid[place];
    } else {
        const std::uint32_t index = place + 1;
        share = {2 * halton(index, 2) - 1, 2 * halton(index, 3) - 1};
    }
    Pose in_area = turned;
    in_area.translation() = Vector3(share[0] * room_x - box.center().x(),
                                    share[1] * room_y - box.center().y(), kPlacementGap - box.lower.z());
    return area_pose(world, area) * in_area;
}

bool stands_in(const BodyModel& body, const Pose& pose, const World& world, const Area& area, double height) {
    constexpr double kTolerance = 1e-6;
    const Pose in_area = area_pose(world, area).inverse() * pose;
    if (in_area.linear()(2, 2) < 1 - kTolerance) return false;
    const AxisBox box = extent(body.shapes, in_area);
    return box.lower.z() >= -kTolerance && box.lower.z() <= height + kTolerance &&
           box.lower.x() >= -area.size[0] / 2 - kTolerance &&
           box.upper.x() <= area.size[0] / 2 + kTolerance &&
           box.lower.y() >= -area.size[1] / 2 - kTolerance && box.upper.y() <= area.size[1] / 2 + kTolerance;
}

}  // namespace praxis::tamp
