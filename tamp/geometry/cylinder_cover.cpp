// Two constructions; the better one is taken.
//
// *Layers*: the cylinder is cut into equal layers, each layer into a disc and rings, each ring into sectors,
// and every piece gets a ball. Good for flat cylinders and for few balls.
//
// *Core and rims*, for cylinders at least as long as wide: balls that hang over the wall a little stand in a
// row on the axis. They cover all but the edges at both ends, where a ring of small balls is put.
#include "tamp/geometry/cylinder_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace praxis::tamp {

namespace {

constexpr double kRounding = 1e-9;

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

void append_ring(std::vector<Ball>& balls, const Ring& ring, double z, double radius) {
    for (std::size_t sector = 0; sector < ring.sectors; ++sector) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(sector) / static_cast<double>(ring.sectors);
        balls.push_back({{ring.radius * std::cos(angle), ring.radius * std::sin(angle), z}, radius});
    }
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

std::vector<Ball> make_layers(const Cylinder& cylinder, const Layers& pattern) {
    const std::vector<Ring> rings =
        cover_disc(cylinder.radius / static_cast<double>(pattern.annuli + 1), pattern.annuli);
    std::vector<Ball> balls;
    for (std::size_t layer = 0; layer < pattern.layers; ++layer) {
        const double share = static_cast<double>(2 * layer + 1) / static_cast<double>(2 * pattern.layers);
        for (const Ring& ring : rings) {
            append_ring(balls, ring, cylinder.length * (share - 0.5), pattern.radius);
        }
    }
    return balls;
}

/// Balls on the axis with `overhang` over the wall, and a ring of balls at both ends.
struct CoreAndRims {
    double overhang = std::numeric_limits<double>::infinity();
    double half_spacing = 0;  ///< of the core: where a ball leaves the wall, seen along the axis
    std::size_t core = 1;
    double depth = 0;  ///< of the rims' centres below wall and end
    Ring rim = {0, 0};

    std::size_t count() const { return core + 2 * rim.sectors; }
};

/// The sectors of a rim whose balls, at this depth below wall and end, cover what the core leaves: in the
/// section through the axis, a triangle at the edge with two sides of length `edge`. 0: more than `limit`.
std::size_t rim_sectors(double radius, double edge, double depth, double overhang, std::size_t limit) {
    const double center = radius - depth;
    const double reach = depth + overhang;
    for (std::size_t sectors = 3; sectors <= limit; ++sectors) {
        const double cosine = std::cos(std::numbers::pi / static_cast<double>(sectors));
        const auto covers = [&](double from_axis, double below_end) {
            const double along = depth - below_end;
            return from_axis * from_axis + center * center - 2 * from_axis * center * cosine +
                       along * along <=
                   reach * reach;
        };
        if (covers(radius - edge, 0) && covers(radius, 0) && covers(radius, edge)) return sectors;
    }
    return 0;
}

CoreAndRims choose_rims(const Cylinder& cylinder, double overhang, std::size_t max_balls) {
    CoreAndRims made;
    made.half_spacing = std::sqrt(overhang * (2 * cylinder.radius + overhang));
    made.core = 1 + static_cast<std::size_t>(
                        std::ceil((cylinder.length - 2 * cylinder.radius) / (2 * made.half_spacing)));
    const double edge = cylinder.radius - made.half_spacing;
    if (made.core > max_balls) return {};
    if (edge > 0) {
        constexpr int kDepths = 24;
        // Deeper balls would not reach the edge without hanging over more.
        const double deepest = std::min(overhang / (std::numbers::sqrt2 - 1), cylinder.radius);
        for (int i = 1; i <= kDepths; ++i) {
            const double depth = deepest * i / kDepths;
            const std::size_t limit = made.rim.sectors > 0 ? made.rim.sectors - 1 : max_balls / 2;
            const std::size_t sectors = rim_sectors(cylinder.radius, edge, depth, overhang, limit);
            if (sectors == 0) continue;
            made.depth = depth;
            made.rim = {cylinder.radius - depth, sectors};
        }
        if (made.rim.sectors == 0) return {};
    }
    if (made.count() > max_balls) return {};
    made.overhang = overhang;
    return made;
}

CoreAndRims choose_rims(const Cylinder& cylinder, const CoverOptions& options) {
    if (cylinder.length < 2 * cylinder.radius) return {};
    constexpr double kStep = 1.1;
    for (double overhang = options.overhang; overhang < cylinder.radius; overhang *= kStep) {
        const CoreAndRims made = choose_rims(cylinder, overhang, options.max_balls);
        if (std::isfinite(made.overhang)) return made;
    }
    return {};
}

std::vector<Ball> make_rims(const Cylinder& cylinder, const CoreAndRims& pattern) {
    std::vector<Ball> balls;
    const double end = cylinder.length / 2 - cylinder.radius;
    for (std::size_t i = 0; i < pattern.core; ++i) {
        const double share =
            pattern.core == 1 ? 0.5 : static_cast<double>(i) / static_cast<double>(pattern.core - 1);
        balls.push_back({{0, 0, end * (2 * share - 1)}, cylinder.radius + pattern.overhang});
    }
    for (const double side : {-1.0, 1.0}) {
        append_ring(balls, pattern.rim, side * (cylinder.length / 2 - pattern.depth),
                    pattern.depth + pattern.overhang);
    }
    return balls;
}

}  // namespace

std::vector<Ball> cover_cylinder(const Cylinder& cylinder, const CoverOptions& options) {
    const Layers layers = choose_layers(cylinder, options);
    const CoreAndRims rims = choose_rims(cylinder, options);
    const bool both_reach = layers.overhang <= options.overhang && rims.overhang <= options.overhang;
    const bool rims_are_better = both_reach ? rims.count() < layers.count : rims.overhang < layers.overhang;
    return rims_are_better ? make_rims(cylinder, rims) : make_layers(cylinder, layers);
}

}  // namespace praxis::tamp
