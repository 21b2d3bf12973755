// The kernel's functions over a type `Lanes` of eight floats. The including file defines `Lanes` first; all
// is local to it, so that code for different processors never mixes.
#pragma once

#include "tamp/collision/kernel.hpp"

namespace praxis::tamp::kernel {
namespace {

struct Point {
    Lanes x;
    Lanes y;
    Lanes z;
};

/// The columns of a rotation, and the translation.
struct Placement {
    Point x;
    Point y;
    Point z;
    Point position;
};

constexpr int kPlacementFloats = 12 * kLanes;
constexpr int kBallFloats = 3 * kLanes;

inline Point load(const float* from) {
    return {Lanes::load(from), Lanes::load(from + kLanes), Lanes::load(from + 2 * kLanes)};
}

inline void store(const Point& point, float* to) {
    point.x.store(to);
    point.y.store(to + kLanes);
    point.z.store(to + 2 * kLanes);
}

/// a * x + b * y + c * z
inline Lanes combine(const Lanes& a, const Lanes& x, const Lanes& b, const Lanes& y, const Lanes& c,
                     const Lanes& z) {
    return multiply_add(a, x, multiply_add(b, y, c * z));
}

inline Point combine(const Placement& p, float a, float b, float c) {
    return {combine(p.x.x, a, p.y.x, b, p.z.x, c), combine(p.x.y, a, p.y.y, b, p.z.y, c),
            combine(p.x.z, a, p.y.z, b, p.z.z, c)};
}

inline Point operator+(const Point& a, const Point& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point scaled(const Point& a, const Lanes& by) {
    return {a.x * by, a.y * by, a.z * by};
}
/// a * s + b * c
inline Point turned(const Point& a, const Lanes& s, const Point& b, const Lanes& c) {
    return {multiply_add(a.x, s, b.x * c), multiply_add(a.y, s, b.y * c), multiply_add(a.z, s, b.z * c)};
}
inline Lanes squared(const Point& a) {
    return combine(a.x, a.x, a.y, a.y, a.z, a.z);
}

/// Sine and cosine: reduction to [-pi/4, pi/4] by a two-part pi/2, minimax polynomials there (error below
/// 1e-7 for |x| < 100).
inline void sine_cosine(const Lanes& x, Lanes& sine, Lanes& cosine) {
    const Lanes quadrant = rounded(x * Lanes(0.63661977F));
    const Lanes r = multiply_subtract(quadrant, -4.3711388e-8F, multiply_subtract(quadrant, 1.5707964F, x));
    const Lanes r2 = r * r;
    const Lanes s = multiply_add(
        r2 * r, multiply_add(r2, multiply_add(r2, -1.9515296e-4F, 8.3321608e-3F), -1.6666655e-1F), r);
    const Lanes c = multiply_add(
        r2 * r2, multiply_add(r2, multiply_add(r2, 2.4433157e-5F, -1.3887316e-3F), 4.1666646e-2F),
        multiply_subtract(r2, 0.5F, 1.0F));
    sine = by_quadrant(quadrant, 0, s, c);
    cosine = by_quadrant(quadrant, 1, c, s);
}

inline void store(const Placement& placement, float* to) {
    store(placement.x, to);
    store(placement.y, to + 3 * kLanes);
    store(placement.z, to + 6 * kLanes);
    store(placement.position, to + 9 * kLanes);
}

inline Placement load_placement(const float* from) {
    return {load(from), load(from + 3 * kLanes), load(from + 6 * kLanes), load(from + 9 * kLanes)};
}

inline Point constant(float x, float y, float z) {
    return {x, y, z};
}

/// Placements of all frames into `placements`.
inline void place_frames(const Model& model, const float* positions, float* placements) {
    for (int f = 0; f < model.frame_count; ++f) {
        const Frame& frame = model.frames[f];
        const float* r = frame.rotation;
        const float* t = frame.translation;
        Placement p;
        if (frame.parent < 0) {
            p = {constant(r[0], r[3], r[6]), constant(r[1], r[4], r[7]), constant(r[2], r[5], r[8]),
                 constant(t[0], t[1], t[2])};
        } else {
            const Placement parent = load_placement(placements + frame.parent * kPlacementFloats);
            p = {combine(parent, r[0], r[3], r[6]), combine(parent, r[1], r[4], r[7]),
                 combine(parent, r[2], r[5], r[8]), combine(parent, t[0], t[1], t[2]) + parent.position};
        }
        const Lanes q =
            multiply_add(Lanes::load(positions + frame.variable * kLanes), frame.multiplier, frame.offset);
        if (frame.prismatic != 0) {
            p.position = p.position + scaled(p.z, q);
        } else {
            Lanes s;
            Lanes c;
            sine_cosine(q, s, c);
            const Point x = turned(p.y, s, p.x, c);
            p.y = turned(p.x, Lanes(0.0F) - s, p.y, c);
            p.x = x;
        }
        store(p, placements + f * kPlacementFloats);
    }
}

inline Point local(const Obstacle& obstacle, const Point& d) {
    const float* a = obstacle.axes;
    return {combine(a[0], d.x, a[1], d.y, a[2], d.z), combine(a[3], d.x, a[4], d.y, a[5], d.z),
            combine(a[6], d.x, a[7], d.y, a[8], d.z)};
}

inline Point upright(const Obstacle& obstacle, const Point& d) {
    const float* a = obstacle.axes;
    return {multiply_add(a[0], d.x, Lanes(a[1]) * d.y), multiply_add(a[3], d.x, Lanes(a[4]) * d.y), d.z};
}

inline Lanes beyond(const Lanes& coordinate, float half) {
    return maximum(absolute(coordinate) - Lanes(half), 0.0F);
}

inline unsigned box_mask(const Point& p, const Obstacle& box_shape, const Lanes& radius) {
    const Point d = {beyond(p.x, box_shape.size[0]), beyond(p.y, box_shape.size[1]),
                     beyond(p.z, box_shape.size[2])};
    return not_greater(squared(d), radius * radius);
}

inline unsigned cylinder_mask(const Point& p, const Obstacle& shape, const Lanes& radius) {
    const Lanes across = maximum(root(multiply_add(p.x, p.x, p.y * p.y)) - Lanes(shape.size[0]), 0.0F);
    const Lanes along = beyond(p.z, shape.size[1]);
    return not_greater(multiply_add(across, across, along * along), radius * radius);
}

/// Which of eight balls touch an obstacle.
template <int kind>
inline unsigned touches(const Obstacle& obstacle, const Point& center, const Lanes& radius) {
    const Point d = center - constant(obstacle.center[0], obstacle.center[1], obstacle.center[2]);
    if constexpr (kind == sphere) {
        const Lanes reach = radius + Lanes(obstacle.size[0]);
        return not_greater(squared(d), reach * reach);
    } else if constexpr (kind == upright_box) {
        return box_mask(upright(obstacle, d), obstacle, radius);
    } else if constexpr (kind == box) {
        return box_mask(local(obstacle, d), obstacle, radius);
    } else if constexpr (kind == upright_cylinder) {
        return cylinder_mask(d, obstacle, radius);
    } else if constexpr (kind == cylinder) {
        return cylinder_mask(local(obstacle, d), obstacle, radius);
    } else {
        const Point p = local(obstacle, d);
        const Lanes along = beyond(p.z, obstacle.size[1]);
        const Lanes reach = radius + Lanes(obstacle.size[0]);
        return not_greater(combine(p.x, p.x, p.y, p.y, along, along), reach * reach);
    }
}

/// The square of the distance to what is occupied is at least the square of that to the box plus the square
/// of what the cell at the nearest point of the box says, for the box is convex and holds all.
inline unsigned touches(const Grid& grid, const Point& p, const Lanes& radius) {
    Lanes outside = 0.0F;
    Lanes place = 0.0F;
    int stride = 1;
    for (int i = 0; i < 3; ++i) {
        const float* a = grid.axes + 3 * i;
        const Lanes x = combine(a[0], p.x, a[1], p.y, a[2], p.z) - Lanes(grid.corner[i]);
        const float length = grid.edge * static_cast<float>(grid.cells[i]);
        const Lanes inside = minimum(maximum(x, 0.0F), length);
        const Lanes away = x - inside;
        outside = multiply_add(away, away, outside);
        const Lanes cell =
            minimum(truncated(inside / Lanes(grid.edge)), static_cast<float>(grid.cells[i] - 1));
        place = multiply_add(cell, static_cast<float>(stride), place);
        stride *= grid.cells[i];
    }
    const Lanes distance = maximum(Lanes::gather(grid.distance, place) + Lanes(grid.slack), 0.0F);
    return not_greater(multiply_add(distance, distance, outside), radius * radius);
}

/// One block of eight configurations on its way through the tests. `all`: every lane's answer is wanted;
/// otherwise the first lane that collides ends the work. `swept`: the balls of part p are larger by growth[p]
/// * width.
template <bool all, bool swept>
class Block {
  public:
    Block(const Model& model, const float* positions, const float* speeds, const Lanes& width, float* scratch)
        : model_(model),
          speeds_(speeds),
          width_(width),
          placements_(scratch),
          bounds_(scratch + model.frame_count * kPlacementFloats),
          centers_(bounds_ + model.part_count * kBallFloats) {
        place_frames(model, positions, placements_);
    }

    unsigned mask() {
        unsigned hit = 0;
        for (int p = 0; p < model_.part_count; ++p) {
            const Part& part = model_.parts[p];
            const Point center = place(part, part.bound.center);
            store(center, bounds_ + p * kBallFloats);
            bool placed = false;
            if (add(hit, against_obstacles<0>(p, center, placed))) return hit;
            if (add(hit, against_grids(p, center, placed))) return hit;
        }
        for (int i = 0; i < model_.pair_count; ++i) {
            if (add(hit, against_part(model_.pairs[i]))) return hit;
        }
        return hit;
    }

  private:
    /// True if the work is done.
    static bool add(unsigned& hit, unsigned more) {
        hit |= more;
        return all ? hit == (1U << kLanes) - 1 : hit != 0;
    }

    Point place(const Part& part, const float* point) const {
        if (part.frame < 0) return constant(point[0], point[1], point[2]);
        const float* frame = placements_ + part.frame * kPlacementFloats;
        const Placement p = load_placement(frame);
        return combine(p, point[0], point[1], point[2]) + p.position;
    }

    Lanes grown(int part, float radius) const {
        if constexpr (swept) return multiply_add(speeds_[part], width_, radius);
        return radius;
    }

    void place_balls(const Part& part, bool& placed) {
        if (placed) return;
        placed = true;
        for (int b = 0; b < part.ball_count; ++b) {
            const int ball = part.first_ball + b;
            store(place(part, model_.balls[ball].center), centers_ + ball * kBallFloats);
        }
    }

    template <class Touches>
    unsigned any_ball(int p, const Touches& test) const {
        const Part& part = model_.parts[p];
        unsigned hit = 0;
        for (int b = 0; b < part.ball_count; ++b) {
            const int ball = part.first_ball + b;
            hit |= test(load(centers_ + ball * kBallFloats), grown(p, model_.balls[ball].radius));
            if (!all && hit != 0) return hit;
        }
        return hit;
    }

    template <int kind>
    unsigned against_obstacles(int p, const Point& center, bool& placed) {
        const Part& part = model_.parts[p];
        const Lanes bound = grown(p, part.bound.radius);
        unsigned hit = 0;
        for (int o = part.first_obstacle[kind]; o < part.first_obstacle[kind + 1]; ++o) {
            const Obstacle& obstacle = model_.obstacles[o];
            if (touches<kind>(obstacle, center, bound) == 0) continue;
            place_balls(part, placed);
            if (add(hit, any_ball(p, [&](const Point& ball, const Lanes& radius) {
                        return touches<kind>(obstacle, ball, radius);
                    }))) {
                return hit;
            }
        }
        if constexpr (kind + 1 < kObstacleKinds) hit |= against_obstacles<kind + 1>(p, center, placed);
        return hit;
    }

    unsigned against_grids(int p, const Point& center, bool& placed) {
        const Part& part = model_.parts[p];
        unsigned hit = 0;
        for (int g = part.first_grid; g < part.first_grid + part.grid_count; ++g) {
            const Grid& grid = model_.grids[g];
            if (touches(grid, center, grown(p, part.bound.radius)) == 0) continue;
            place_balls(part, placed);
            if (add(hit, any_ball(p, [&](const Point& ball, const Lanes& radius) {
                        return touches(grid, ball, radius);
                    }))) {
                return hit;
            }
        }
        return hit;
    }

    static unsigned balls_touch(const Point& a, const Lanes& a_radius, const Point& b,
                                const Lanes& b_radius) {
        const Lanes reach = a_radius + b_radius;
        return not_greater(squared(a - b), reach * reach);
    }

    unsigned against_part(const PartPair& pair) {
        const Part& first = model_.parts[pair.first];
        const Part& second = model_.parts[pair.second];
        const Point first_center = load(bounds_ + pair.first * kBallFloats);
        const Point second_center = load(bounds_ + pair.second * kBallFloats);
        const Lanes second_bound = grown(pair.second, second.bound.radius);
        if (balls_touch(first_center, grown(pair.first, first.bound.radius), second_center, second_bound) ==
            0) {
            return 0;
        }
        unsigned hit = 0;
        for (int b = first.first_ball; b < first.first_ball + first.ball_count; ++b) {
            const Point center = place(first, model_.balls[b].center);
            const Lanes radius = grown(pair.first, model_.balls[b].radius);
            if (balls_touch(center, radius, second_center, second_bound) == 0) continue;
            for (int c = second.first_ball; c < second.first_ball + second.ball_count; ++c) {
                const Point other = place(second, model_.balls[c].center);
                hit |= balls_touch(center, radius, other, grown(pair.second, model_.balls[c].radius));
                if (!all && hit != 0) return hit;
            }
        }
        return hit;
    }

    const Model& model_;
    const float* speeds_;
    Lanes width_;
    float* placements_;
    float* bounds_;
    float* centers_;
};

/// Positions at places `t` of a segment.
inline void interpolate(const Model& model, const float* from, const float* change, const Lanes& t,
                        float* positions) {
    for (int v = 0; v < model.variable_count; ++v) {
        multiply_add(change[v], t, from[v]).store(positions + v * kLanes);
    }
}

constexpr int kMaxVariables = 16;

unsigned collisions(const Model& model, const float* positions, float* scratch) {
    return Block<true, false>(model, positions, nullptr, 0.0F, scratch).mask();
}

bool motion_free(const Model& model, const float* from, const float* change, int rakes, bool with_start,
                 float* scratch) {
    alignas(32) float positions[kMaxVariables * kLanes];
    alignas(32) float places[kLanes];
    const int first = with_start ? 0 : 1;
    const float step = 1.0F / static_cast<float>(kLanes * rakes - 1 + first);
    for (int i = 0, turns = rake_turns(rakes); i < turns; ++i) {
        const int rake = rake_at(i, rakes);
        if (rake < 0) continue;
        for (int lane = 0; lane < kLanes; ++lane) {
            places[lane] = static_cast<float>(lane * rakes + rake + first) * step;
        }
        interpolate(model, from, change, Lanes::load(places), positions);
        if (Block<false, false>(model, positions, nullptr, 0.0F, scratch).mask() != 0) return false;
    }
    return true;
}

unsigned swept_collisions(const Model& model, const float* from, const float* change, const float* t,
                          const float* width, const float* speeds, float* scratch) {
    alignas(32) float positions[kMaxVariables * kLanes];
    interpolate(model, from, change, Lanes::load(t), positions);
    return Block<true, true>(model, positions, speeds, Lanes::load(width), scratch).mask();
}

}  // namespace
}  // namespace praxis::tamp::kernel
