#include "tamp/geometry/cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

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

/// Centres on a ring whose sectors make up an annulus.
struct Ring {
    double radius = 0;
    std::size_t sectors = 1;
};

/// A disc of radius `width`, and annuli of that width around it, cut into sectors that fit into discs of
/// that radius.
std::vector<Ring> cover_disc(double width, std::size_t annuli) {
    std::vector<Ring> rings = {{0, 1}};
    for (std::size_t i = 1; i <= annuli; ++i) {
        const double inner = width * static_cast<double>(i);
        const double outer = inner + width;
        Ring ring{0, 2};
        double reach = 0;
        do {
            ++ring.sectors;
            const double angle = std::numbers::pi / static_cast<double>(ring.sectors);
            ring.radius = std::min((inner + outer) / (2 * std::cos(angle)), outer * std::cos(angle));
            const auto to_corner = [&](double radius) {
                return std::hypot(radius * std::cos(angle) - ring.radius, radius * std::sin(angle));
            };
            reach = std::max({to_corner(inner), to_corner(outer), outer - ring.radius});
        } while (reach > width * (1 + kRounding));
        rings.push_back(ring);
    }
    return rings;
}

/// A cover of a cylinder by equal layers of one pattern of rings.
struct Layers {
    std::size_t annuli = 0;
    std::size_t layers = 1;
    std::size_t count = 1;
    double radius = 0;
    double overhang = std::numeric_limits<double>::infinity();
};

Layers choose_layers(const Cylinder& cylinder, const CoverOptions& options) {
    Layers best;
    for (std::size_t annuli = 0;; ++annuli) {
        const double width = cylinder.radius / static_cast<double>(annuli + 1);
        const std::vector<Ring> rings = cover_disc(width, annuli);
        std::size_t in_layer = 0;
        for (const Ring& ring : rings) in_layer += ring.sectors;
        const bool reached = best.overhang <= options.overhang;
        if (in_layer > options.max_balls || (reached && in_layer >= best.count)) return best;
        const double wall = cylinder.radius - rings.back().radius;
        for (std::size_t layers = 1; layers * in_layer <= options.max_balls; ++layers) {
            const double half_layer = cylinder.length / static_cast<double>(2 * layers);
            const double radius = std::hypot(width, half_layer);
            const Layers made{annuli, layers, layers * in_layer, radius, radius - std::min(half_layer, wall)};
            const bool better = best.overhang <= options.overhang
                                    ? made.overhang <= options.overhang && made.count < best.count
                                    : made.overhang < best.overhang;
            if (better) best = made;
            if (made.overhang <= options.overhang || half_layer <= wall) break;
        }
    }
}

std::vector<Ball> cover_cylinder(const Cylinder& cylinder, const CoverOptions& options) {
    require_size(cylinder.radius, "the radius of a cylinder");
    require_size(cylinder.length, "the length of a cylinder");
    const Layers pattern = choose_layers(cylinder, options);
    const std::vector<Ring> rings =
        cover_disc(cylinder.radius / static_cast<double>(pattern.annuli + 1), pattern.annuli);
    std::vector<Ball> balls;
    for (std::size_t layer = 0; layer < pattern.layers; ++layer) {
        const double share = static_cast<double>(2 * layer + 1) / static_cast<double>(2 * pattern.layers);
        for (const Ring& ring : rings) {
            for (std::size_t sector = 0; sector < ring.sectors; ++sector) {
                const double angle =
                    2 * std::numbers::pi * static_cast<double>(sector) / static_cast<double>(ring.sectors);
                balls.push_back({{ring.radius * std::cos(angle), ring.radius * std::sin(angle),
                                  cylinder.length * (share - 0.5)},
                                 padded(pattern.radius)});
            }
        }
    }
    return balls;
}

struct CoverVisitor {
    const CoverOptions& options;

    std::vector<Ball> operator()(const Sphere& sphere) const { return cover_sphere(sphere); }
    std::vector<Ball> operator()(const Box& box) const { return cover_box(box, options); }
    std::vector<Ball> operator()(const Cylinder& cylinder) const { return cover_cylinder(cylinder, options); }
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

}  // namespace praxis::tamp
