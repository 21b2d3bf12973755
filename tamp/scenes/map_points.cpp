#include "tamp/scenes/map_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace praxis::tamp {

namespace {

AxisBox box_around_points(std::span<const Vector3> points, const PointMapOptions& options) {
    std::optional<AxisBox> box;
    const auto include = [&](const Vector3& point) {
        if (!point.allFinite()) return;
        if (!box) box = AxisBox{point, point};
        box->include({point, point});
    };
    for (const Vector3& point : points) include(point);
    if (!box) throw std::invalid_argument("there are no points; give the map a box");
    if (options.sensor) include(*options.sensor);
    // A point on a border belongs to the cell behind it.
    box->upper.array() += 0.5 * options.edge;
    return *box;
}

/// The part of a segment that lies in a box, as two shares of its length; nothing if none does.
std::optional<std::array<double, 2>> clip(const Vector3& from, const Vector3& to, const AxisBox& box) {
    double enter = 0;
    double leave = 1;
    const Vector3 way = to - from;
    for (int axis = 0; axis < 3; ++axis) {
        if (way[axis] == 0) {
            if (from[axis] < box.lower[axis] || from[axis] > box.upper[axis]) return std::nullopt;
            continue;
        }
        const double first = (box.lower[axis] - from[axis]) / way[axis];
        const double second = (box.upper[axis] - from[axis]) / way[axis];
        enter = std::max(enter, std::min(first, second));
        leave = std::min(leave, std::max(first, second));
    }
    if (enter > leave) return std::nullopt;
    return std::array<double, 2>{enter, leave};
}

class MapMaker {
  public:
    explicit MapMaker(const VoxelGrid& grid, Occupancy unseen) : grid_(grid), cells_(grid.size(), unseen) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<std::size_t>(axis);
            box_.lower[axis] = grid.origin[at];
            box_.upper[axis] = grid.origin[at] + grid.edge * grid.cells[at];
        }
    }

    /// Walks the cells of a ray up to that of the point (Amanatides and Woo 1987).
    void add_ray(const Vector3& sensor, const Vector3& point) {
        const auto part = clip(sensor, point, box_);
        if (!part) return;
        const Vector3 way = point - sensor;
        std::array<int, 3> cell = nearest_cell(sensor + (*part)[0] * way);
        std::array<int, 3> step = {};
        std::array<double, 3> next = {};
        std::array<double, 3> pace = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto at = static_cast<Eigen::Index>(axis);
            step[axis] = way[at] > 0 ? 1 : -1;
            const double border = grid_.origin[axis] + grid_.edge * (cell[axis] + (way[at] > 0 ? 1 : 0));
            next[axis] =
                way[at] == 0 ? std::numeric_limits<double>::infinity() : (border - sensor[at]) / way[at];
            pace[axis] = way[at] == 0 ? 0 : grid_.edge / std::abs(way[at]);
        }
        while (grid_.has(cell[0], cell[1], cell[2])) {
            const auto axis = static_cast<std::size_t>(std::ranges::min_element(next) - next.begin());
            const bool last = next[axis] > (*part)[1];
            if (last && (*part)[1] >= 1) return;
            cells_[grid_.index(cell[0], cell[1], cell[2])] = Occupancy::free;
            if (last) return;
            cell[axis] += step[axis];
            next[axis] += pace[axis];
        }
    }

    void add_points(std::span<const Vector3> points, std::size_t least) {
        std::vector<std::uint32_t> counts(grid_.size(), 0);
        for (const Vector3& point : points) {
            if (!point.allFinite()) continue;
            std::array<int, 3> cell = {};
            bool inside = true;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double place =
                    std::floor((point[static_cast<Eigen::Index>(axis)] - grid_.origin[axis]) / grid_.edge);
                inside = inside && place >= 0 && place < grid_.cells[axis];
                cell[axis] = inside ? static_cast<int>(place) : 0;
            }
            if (!inside) continue;
            const std::size_t index = grid_.index(cell[0], cell[1], cell[2]);
            if (++counts[index] >= least) cells_[index] = Occupancy::occupied;
        }
    }

    std::vector<Occupancy> cells() { return std::move(cells_); }

  private:
    std::array<int, 3> nearest_cell(const Vector3& point) const {
        std::array<int, 3> cell = {};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double place =
                std::floor((point[static_cast<Eigen::Index>(axis)] - grid_.origin[axis]) / grid_.edge);
            cell[axis] = static_cast<int>(std::clamp(place, 0.0, grid_.cells[axis] - 1.0));
        }
        return cell;
    }

    VoxelGrid grid_;
    AxisBox box_;
    std::vector<Occupancy> cells_;
};

}  // namespace

OccupancyMap map_points(std::span<const Vector3> points, const PointMapOptions& options) {
    if (options.least_points < 1)
        throw std::invalid_argument("a voxel with points needs at least one of them");
    if (options.sensor && !options.sensor->allFinite()) {
        throw std::invalid_argument("the place of the sensor must be finite");
    }
    const VoxelGrid grid =
        aligned_grid(options.box ? *options.box : box_around_points(points, options), options.edge);
    MapMaker maker(grid, options.sensor ? Occupancy::unknown : Occupancy::free);
    if (options.sensor) {
        for (const Vector3& point : points) {
            if (point.allFinite()) maker.add_ray(*options.sensor, point);
        }
    }
    maker.add_points(points, options.least_points);
    return OccupancyMap(grid, maker.cells(), options.unknown_blocks);
}

}  // namespace praxis::tamp
