#include "belief/perception/depth_camera.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "belief/perception/errors.hpp"

namespace praxis::belief {

void DepthCamera::check() const {
    if (depth.height != 0 && depth.width > depth.metres.max_size() / depth.height) {
        throw PerceptionError("a depth image is too large");
    }
    if (depth.metres.size() != depth.width * depth.height) {
        throw PerceptionError("a depth image of " + std::to_string(depth.width) + " x " +
                              std::to_string(depth.height) + " pixels has " +
                              std::to_string(depth.metres.size()) + " values");
    }
    if (!(pinhole.fx > 0) || !(pinhole.fy > 0)) throw PerceptionError("focal lengths must be positive");
}

std::optional<Position> DepthCamera::lift(double u, double v) const {
    const double width = static_cast<double>(depth.width);
    const double height = static_cast<double>(depth.height);
    if (!(u >= -0.5 && u < width - 0.5 && v >= -0.5 && v < height - 0.5)) return std::nullopt;
    const auto column = static_cast<std::size_t>(std::lround(std::clamp(u, 0.0, width - 1)));
    const auto row = static_cast<std::size_t>(std::lround(std::clamp(v, 0.0, height - 1)));

    std::array<float, 9> valid{};
    std::size_t count = 0;
    std::size_t pixels = 0;
    for (std::size_t y = row == 0 ? 0 : row - 1; y <= std::min(row + 1, depth.height - 1); ++y) {
        for (std::size_t x = column == 0 ? 0 : column - 1; x <= std::min(column + 1, depth.width - 1); ++x) {
            ++pixels;
            const float metres = depth.metres[y * depth.width + x];
            if (metres >= nearest && metres <= farthest) valid[count++] = metres;
        }
    }
    if (count == 0 || count * 2 < pixels) return std::nullopt;
    const auto middle = valid.begin() + static_cast<std::ptrdiff_t>((count - 1) / 2);
    std::nth_element(valid.begin(), middle, valid.begin() + static_cast<std::ptrdiff_t>(count));

    const double z = static_cast<double>(*middle);
    const double x = (u - pinhole.cx) / pinhole.fx * z;
    const double y = (v - pinhole.cy) / pinhole.fy * z;
    const auto& r = pose.rotation;
    return Position{r[0][0] * x + r[0][1] * y + r[0][2] * z + pose.translation.x,
                    r[1][0] * x + r[1][1] * y + r[1][2] * z + pose.translation.y,
                    r[2][0] * x + r[2][1] * y + r[2][2] * z + pose.translation.z};
}

std::optional<std::array<double, 2>> DepthCamera::project(const Position& point) const {
    const double dx = point.x - pose.translation.x;
    const double dy = point.y - pose.translation.y;
    const double dz = point.z - pose.translation.z;
    const auto& r = pose.rotation;  // its inverse is its transpose
    const double x = r[0][0] * dx + r[1][0] * dy + r[2][0] * dz;
    const double y = r[0][1] * dx + r[1][1] * dy + r[2][1] * dz;
    const double z = r[0][2] * dx + r[1][2] * dy + r[2][2] * dz;
    if (!(z > 0)) return std::nullopt;
    return std::array<double, 2>{x / z * pinhole.fx + pinhole.cx, y / z * pinhole.fy + pinhole.cy};
}

}  // namespace praxis::belief
