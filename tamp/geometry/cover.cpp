#include "tamp/geometry/cover.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tamp/geometry/cylinder_cover.hpp"
#include "tamp/geometry/mesh_cover.hpp"

namespace praxis::tamp {

namespace {

// Rounding may not uncover anything.
constexpr double kRounding = 1e-9;
constexpr std::size_t kMaximumBalls = 100'000;

double padded(double radius) {
    return radius * (1 + kRounding) + 1e-12;
}

void require_size(double size, const char* what) {
    if (!(size >= 0) || !std::isfinite(size)) {
        throw std::invalid_argument(std::string(what) + " must be finite and not negative");
    }
}

std::vector<Ball> cover_sphere(const Sphere& sphere) {
    require_size(sphere.radius, "the radius of a sphere");
    return {{Vector3::Zero(), sphere.radius}};
}

/// Balls around the cells of a grid of as few cells as reach the overhang.
std::vector<Ball> cover_box(const Box& box, const CoverOptions& options) {
    for (const double size : box.size) require_size(size, "the size of a box");
    std::array<std::size_t, 3> cells = {1, 1, 1};
    const auto half_cell = [&] {
        return Vector3(box.size.x() / static_cast<double>(2 * cells[0]),
                       box.size.y() / static_cast<double>(2 * cells[1]),
                       box.size.z() / static_cast<double>(2 * cells[2]));
    };
    while (half_cell().norm() - half_cell().minCoeff() > options.overhang) {
        Eigen::Index longest = 0;
        half_cell().maxCoeff(&longest);
        const std::size_t count = cells[0] * cells[1] * cells[2];
        std::size_t& split = cells[static_cast<std::size_t>(longest)];
        if (count / split * (split + 1) > options.max_balls) break;
        ++split;
    }
    const Vector3 half = half_cell();
    std::vector<Ball> balls;
    for (std::size_t x = 0; x < cells[0]; ++x) {
        for (std::size_t y = 0; y < cells[1]; ++y) {
            for (std::size_t z = 0; z < cells[2]; ++z) {
                const Vector3 cell(static_cast<double>(2 * x + 1), static_cast<double>(2 * y + 1),
                                   static_cast<double>(2 * z + 1));
                balls.push_back({half.cwiseProduct(cell) - box.size / 2, padded(half.norm())});
            }
        }
    }
    return balls;
}

/// The overhang with which `count` balls cover a capsule: the outer centres stand that far inside of the
/// segment's ends, neighbours meet on the capsule's wall.
double capsule_overhang(const Capsule& capsule, std::size_t count) {
    const auto reaches = [&](double overhang) {
        const double meet = std::sqrt(2 * capsule.radius * overhang + overhang * overhang);
        return 2 * overhang + static_cast<double>(2 * (count - 1)) * meet >= capsule.length;
    };
    double low = 0;
    double high = capsule.length / 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (reaches(middle) ? high : low) = middle;
    }
    return high;
}

std::vector<Ball> cover_capsule(const Capsule& capsule, const CoverOptions& options) {
    require_size(capsule.radius, "the radius of a capsule");
    require_size(capsule.length, "the length of a capsule");
    std::size_t count = 1;
    while (count < options.max_balls && capsule_overhang(capsule, count) > options.overhang) ++count;
    const double overhang = capsule_overhang(capsule, count);
    const double end = capsule.length / 2 - overhang;
    std::vector<Ball> balls;
    for (std::size_t i = 0; i < count; ++i) {
        const double share = count == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(count - 1);
        balls.push_back({{0, 0, end * (2 * share - 1)}, padded(capsule.radius + overhang)});
    }
    return balls;
}

struct CoverVisitor {
    const CoverOptions& options;

    std::vector<Ball> operator()(const Sphere& sphere) const { return cover_sphere(sphere); }
    std::vector<Ball> operator()(const Box& box) const { return cover_box(box, options); }
    std::vector<Ball> operator()(const Cylinder& cylinder) const {
        require_size(cylinder.radius, "the radius of a cylinder");
        require_size(cylinder.length, "the length of a cylinder");
        std::vector<Ball> balls = cover_cylinder(cylinder, options);
        for (Ball& ball : balls) ball.radius = padded(ball.radius);
        return balls;
    }
    std::vector<Ball> operator()(const Capsule& capsule) const { return cover_capsule(capsule, options); }
    std::vector<Ball> operator()(const std::shared_ptr<const Mesh>& mesh) const {
        if (!mesh) throw std::invalid_argument("a mesh without content has no cover");
        return cover_mesh(*mesh, options);
    }
    std::vector<Ball> operator()(const std::shared_ptr<const OccupancyMap>&) const {
        throw std::invalid_argument("an occupancy map has no cover");
    }
};

bool contains(const Ball& outer, const Ball& inner) {
    return (outer.center - inner.center).norm() + inner.radius <= outer.radius;
}

std::vector<Ball> without_inner_balls(const std::vector<Ball>& balls) {
    std::vector<Ball> outer;
    for (const Ball& ball : balls) {
        if (std::ranges::any_of(outer, [&](const Ball& other) { return contains(other, ball); })) continue;
        std::erase_if(outer, [&](const Ball& other) { return contains(ball, other); });
        outer.push_back(ball);
    }
    return outer;
}

}  // namespace

std::vector<Ball> cover(const Shape& shape, const CoverOptions& options) {
    if (!(options.overhang > 0) || !std::isfinite(options.overhang) || options.max_balls == 0 ||
        options.max_balls > kMaximumBalls) {
        throw std::invalid_argument("a cover needs an overhang above 0 and 1 to 100000 balls");
    }
    return std::visit(CoverVisitor{options}, shape);
}

std::vector<Ball> cover(std::span<const PlacedShape> shapes, const CoverOptions& options) {
    std::vector<Ball> balls;
    for (const PlacedShape& placed : shapes) {
        for (const Ball& ball : cover(placed.shape, options)) {
            balls.push_back({placed.pose * ball.center, ball.radius});
        }
    }
    return without_inner_balls(balls);
}

Ball bounding_ball(std::span<const Ball> balls) {
    if (balls.empty()) return {};
    const auto reach = [](const Vector3& center, const Ball& ball) {
        return (ball.center - center).norm() + ball.radius;
    };
    const auto farthest = [&](const Vector3& center) {
        return *std::ranges::max_element(balls, {}, [&](const Ball& ball) { return reach(center, ball); });
    };
    Ball best{balls.front().center, reach(balls.front().center, farthest(balls.front().center))};
    Vector3 center = best.center;
    for (int i = 1; i <= 64; ++i) {
        const Ball far = farthest(center);
        const Vector3 away = far.center - center;
        const double distance = away.norm();
        if (reach(center, far) < best.radius) best = {center, reach(center, far)};
        if (distance == 0) break;
        // The farthest point of the farthest ball pulls.
        center += away / distance * (distance + far.radius) / (i + 1);
    }
    const double last = reach(center, farthest(center));
    if (last < best.radius) best = {center, last};
    best.radius = balls.size() == 1 ? balls.front().radius : padded(best.radius);
    return best;
}

Ball bounding_ball(const Ball& first, const Ball& second) {
    const Vector3 apart = second.center - first.center;
    const double distance = apart.norm();
    if (distance + second.radius <= first.radius) return first;
    if (distance + first.radius <= second.radius) return second;
    const double radius = (distance + first.radius + second.radius) / 2;
    return {first.center + apart * ((radius - first.radius) / distance), padded(radius)};
}

}  // namespace praxis::tamp
