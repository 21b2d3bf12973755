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
constexpr int kVelocityFloats = 6 * kLanes;

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
            const float* at = placements + frame.parent * kPlacementFloats;
            const Placement parent = load_placement(at);
            p.position = combine(parent, t[0], t[1], t[2]) + parent.position;
            if (frame.by_quarters != 0) {
                p.x = scaled(load(at + frame.source[0] * 3 * kLanes), frame.sign[0]);
                p.y = scaled(load(at + frame.source[1] * 3 * kLanes), frame.sign[1]);
                p.z = scaled(load(at + frame.source[2] * 3 * kLanes), frame.sign[2]);
            } else {
                p.x = combine(parent, r[0], r[3], r[6]);
                p.y = combine(parent, r[1], r[4], r[7]);
                p.z = combine(parent, r[2], r[5], r[8]);
            }
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

inline Point cross(const Point& a, const Point& b) {
    return {multiply_subtract(a.z, b.y, a.y * b.z), multiply_subtract(a.x, b.z, a.z * b.x),
            multiply_subtract(a.y, b.x, a.x * b.y)};
}

/// How a frame turns, and how its origin moves, for a unit of a segment.
struct Velocity {
    Point turn;
    Point origin;
};

inline Velocity load_velocity(const float* from) {
    return {load(from), load(from + 3 * kLanes)};
}

/// Of all frames, whose placements are given.
inline void place_velocities(const Model& model, const float* change, const float* placements,
                             float* velocities) {
    for (int f = 0; f < model.frame_count; ++f) {
        const Frame& frame = model.frames[f];
        const Point axis = load(placements + f * kPlacementFloats + 6 * kLanes);
        const Point origin = load(placements + f * kPlacementFloats + 9 * kLanes);
        Velocity velocity = {constant(0, 0, 0), constant(0, 0, 0)};
        if (frame.parent >= 0) {
            velocity = load_velocity(velocities + frame.parent * kVelocityFloats);
            const Point parent = load(placements + frame.parent * kPlacementFloats + 9 * kLanes);
            velocity.origin = velocity.origin + cross(velocity.turn, origin - parent);
        }
        const Point added = scaled(axis, frame.multiplier * change[frame.variable]);
        if (frame.prismatic != 0) {
            velocity.origin = velocity.origin + added;
        } else {
            velocity.turn = velocity.turn + added;
        }
        store(velocity.turn, velocities + f * kVelocityFloats);
        store(velocity.origin, velocities + f * kVelocityFloats + 3 * kLanes);
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

inline Lanes box_gap(const Point& p, const Obstacle& obstacle) {
    return squared(
        {beyond(p.x, obstacle.size[0]), beyond(p.y, obstacle.size[1]), beyond(p.z, obstacle.size[2])});
}

inline Lanes cylinder_gap(const Point& p, const Obstacle& obstacle) {
    const Lanes across = maximum(root(multiply_add(p.x, p.x, p.y * p.y)) - Lanes(obstacle.size[0]), 0.0F);
    const Lanes along = beyond(p.z, obstacle.size[1]);
    return multiply_add(across, across, along * along);
}

/// Spheres and capsules are points and segments, grown by their radius.
template <int kind>
inline constexpr bool is_grown = kind == sphere || kind == capsule;

/// Squares of the distances of eight points to an obstacle, or to its core if it is grown.
template <int kind>
inline Lanes squared_gap(const Obstacle& obstacle, const Point& point) {
    const Point d = point - constant(obstacle.center[0], obstacle.center[1], obstacle.center[2]);
    if constexpr (kind == sphere) return squared(d);
    if constexpr (kind == upright_box) return box_gap(upright(obstacle, d), obstacle);
    if constexpr (kind == box) return box_gap(local(obstacle, d), obstacle);
    if constexpr (kind == upright_cylinder) return cylinder_gap(d, obstacle);
    if constexpr (kind == cylinder) return cylinder_gap(local(obstacle, d), obstacle);
    if constexpr (kind == capsule) {
        const Point p = local(obstacle, d);
        const Lanes along = beyond(p.z, obstacle.size[1]);
        return combine(p.x, p.x, p.y, p.y, along, along);
    }
}

/// The square of the distance to what is occupied is at least the square of that to the box plus the square
/// of what the cell at the nearest point of the box says, for the box is convex and holds all.
inline Lanes squared_gap(const Grid& grid, const Point& p) {
    Lanes outside = 0.0F;
    Lanes cell[3];
    for (int i = 0; i < 3; ++i) {
        const float* a = grid.axes + 3 * i;
        const Lanes x = combine(a[0], p.x, a[1], p.y, a[2], p.z) - Lanes(grid.corner[i]);
        const Lanes inside = minimum(maximum(x, 0.0F), grid.edge * static_cast<float>(grid.cells[i]));
        const Lanes away = x - inside;
        outside = multiply_add(away, away, outside);
        cell[i] = minimum(inside / Lanes(grid.edge), static_cast<float>(grid.cells[i] - 1));
    }
    const Lanes distance =
        Lanes::gather(grid.distance, cell[0], cell[1], cell[2], grid.cells[0], grid.cells[1]) +
        Lanes(grid.slack);
    if (grid.slack > 0) {
        const Lanes at_most = root(outside) + distance;
        return at_most * at_most;
    }
    return multiply_add(distance, distance, outside);
}

/// Which of eight gaps balls of this radius bridge.
inline unsigned bridged(const Lanes& squared_gap, const Lanes& radius) {
    return not_greater(squared_gap, radius * radius);
}

/// What a part may touch, as the rest of the kernel sees it: gaps to it, and what adds to the radius of a
/// ball.
template <int kind>
struct Solid {
    const Obstacle& obstacle;
    Lanes gap(const Point& point) const { return squared_gap<kind>(obstacle, point); }
    Lanes reach(const Lanes& radius) const {
        if constexpr (is_grown<kind>) return radius + Lanes(obstacle.size[0]);
        return radius;
    }
};

struct Cells {
    const Grid& grid;
    Lanes gap(const Point& point) const { return squared_gap(grid, point); }
    Lanes reach(const Lanes& radius) const { return radius; }
};

/// Eight configurations: their frames, and the balls that somebody asked for.
class Block {
  public:
    Block(const Model& model, float* scratch)
        : model_(model), placements_(scratch), bounds_(scratch + model.frame_count * kPlacementFloats) {
        clusters_ = bounds_ + model.part_count * kBallFloats;
        balls_ = clusters_ + model.cluster_count * kBallFloats;
        int balls = 0;
        for (int c = 0; c < model.cluster_count; ++c) balls += model.clusters[c].ball_count;
        velocities_ = balls_ + balls * kBallFloats;
        growths_ = velocities_ + model.frame_count * kVelocityFloats;
    }

    void place(const float* positions) { place_frames(model_, positions, placements_); }

    void place_moving(const float* positions, const float* change) {
        place(positions);
        place_velocities(model_, change, placements_, velocities_);
    }

    void place_bound(int p) {
        store(at(model_.parts[p].frame, model_.parts[p].bound), bounds_ + p * kBallFloats);
        clusters_placed_[p] = false;
    }

    /// The speed of the ball of a part that moves fastest, at most.
    Lanes speed(int p) const {
        const Part& part = model_.parts[p];
        if (part.frame < 0) return 0.0F;
        const Velocity v = load_velocity(velocities_ + part.frame * kVelocityFloats);
        const Point origin = load(placements_ + part.frame * kPlacementFloats + 9 * kLanes);
        const Point center = v.origin + cross(v.turn, bound(p) - origin);
        return multiply_add(root(squared(v.turn)), part.spread, root(squared(center)));
    }

    const Model& model() const { return model_; }
    float* growth(int p) const { return growths_ + p * kLanes; }
    Point bound(int p) const { return load(bounds_ + p * kBallFloats); }
    float bound_radius(int p) const { return model_.parts[p].bound.radius; }
    Point cluster_bound(int c) const { return load(clusters_ + c * kBallFloats); }
    float cluster_radius(int c) const { return model_.clusters[c].bound.radius; }
    Point center(int ball) const { return load(balls_ + ball * kBallFloats); }
    float radius(int ball) const { return model_.balls[ball].radius; }

    int first_cluster(int p) const { return model_.parts[p].first_cluster; }
    int end_cluster(int p) const { return first_cluster(p) + model_.parts[p].cluster_count; }
    int first_ball(int c) const { return model_.clusters[c].first_ball; }
    int end_ball(int c) const { return first_ball(c) + model_.clusters[c].ball_count; }

    void place_clusters(int p) {
        if (clusters_placed_[p]) return;
        clusters_placed_[p] = true;
        for (int c = first_cluster(p); c < end_cluster(p); ++c) {
            store(at(model_.parts[p].frame, model_.clusters[c].bound), clusters_ + c * kBallFloats);
            balls_placed_[c % kFlags] = -1;
        }
    }

    void place_balls(int p, int c) {
        if (balls_placed_[c % kFlags] == c) return;
        balls_placed_[c % kFlags] = c;
        for (int ball = first_ball(c); ball < end_ball(c); ++ball) {
            store(at(model_.parts[p].frame, model_.balls[ball]), balls_ + ball * kBallFloats);
        }
    }

  private:
    static constexpr int kFlags = 256;

    Point at(int frame, const Ball& ball) const {
        const float* point = ball.center;
        if (frame < 0) return constant(point[0], point[1], point[2]);
        const Placement p = load_placement(placements_ + frame * kPlacementFloats);
        return combine(p, point[0], point[1], point[2]) + p.position;
    }

    const Model& model_;
    float* placements_;
    float* bounds_;
    float* clusters_;
    float* balls_;
    float* velocities_;
    float* growths_;
    bool clusters_placed_[kMaxParts];
    int balls_placed_[kFlags];  ///< which cluster, of those that share the flag
};

/// How a test goes on when balls touch. Before anything is asked of a part, `enter` is told of it; radii are
/// those of the model plus how much the part has grown.
///
/// Any: the first touch ends all work. Every: all lanes are wanted. EverySwept: of stretches of a segment.
struct Any {
    unsigned hit = 0;
    bool add(unsigned mask) { return (hit |= mask) != 0; }
    static void enter(const Block&, int) {}
    static Lanes grown(const Block&, int, float radius) { return radius; }
};

struct Every {
    unsigned hit = 0;
    bool add(unsigned mask) { return (hit |= mask) == (1U << kLanes) - 1; }
    static void enter(const Block&, int) {}
    static Lanes grown(const Block&, int, float radius) { return radius; }
};

struct EverySwept {
    const float* sweeps;
    float turn;
    Lanes width;
    unsigned hit = 0;
    bool add(unsigned mask) { return (hit |= mask) == (1U << kLanes) - 1; }
    void enter(const Block& block, int p) const {
        constexpr float kRounding = 1e-5F;
        const Lanes bend = multiply_add(width, 0.5F * turn, kRounding);
        const Lanes speed = multiply_add(bend, sweeps[p], block.speed(p));
        (minimum(speed, sweeps[p]) * width).store(block.growth(p));
    }
    static Lanes grown(const Block& block, int p, float radius) {
        return Lanes::load(block.growth(p)) + Lanes(radius);
    }
};

/// True: the work is done.
template <class Mode, class Other>
inline bool part_touches(Block& block, int p, const Other& other, Mode& mode) {
    if (bridged(other.gap(block.bound(p)), other.reach(Mode::grown(block, p, block.bound_radius(p)))) == 0)
        return false;
    block.place_clusters(p);
    for (int c = block.first_cluster(p); c < block.end_cluster(p); ++c) {
        const Lanes bound = Mode::grown(block, p, block.cluster_radius(c));
        if (bridged(other.gap(block.cluster_bound(c)), other.reach(bound)) == 0) continue;
        block.place_balls(p, c);
        for (int ball = block.first_ball(c); ball < block.end_ball(c); ++ball) {
            const Lanes radius = Mode::grown(block, p, block.radius(ball));
            if (mode.add(bridged(other.gap(block.center(ball)), other.reach(radius)))) return true;
        }
    }
    return false;
}

template <class Mode>
inline bool clusters_touch(Block& block, const PartPair& pair, int c, int d, Mode& mode) {
    block.place_balls(pair.first, c);
    block.place_balls(pair.second, d);
    const Point bound = block.cluster_bound(d);
    const Lanes bound_radius = Mode::grown(block, pair.second, block.cluster_radius(d));
    for (int ball = block.first_ball(c); ball < block.end_ball(c); ++ball) {
        const Point center = block.center(ball);
        const Lanes radius = Mode::grown(block, pair.first, block.radius(ball));
        if (bridged(squared(center - bound), radius + bound_radius) == 0) continue;
        for (int other = block.first_ball(d); other < block.end_ball(d); ++other) {
            const Lanes reach = radius + Mode::grown(block, pair.second, block.radius(other));
            if (mode.add(bridged(squared(center - block.center(other)), reach))) return true;
        }
    }
    return false;
}

template <class Mode>
inline bool parts_touch(Block& block, const PartPair& pair, Mode& mode) {
    const int p = pair.first;
    const int q = pair.second;
    const Point bound = block.bound(q);
    const Lanes bound_radius = Mode::grown(block, q, block.bound_radius(q));
    if (bridged(squared(block.bound(p) - bound),
                Mode::grown(block, p, block.bound_radius(p)) + bound_radius) == 0) {
        return false;
    }
    block.place_clusters(p);
    block.place_clusters(q);
    for (int c = block.first_cluster(p); c < block.end_cluster(p); ++c) {
        const Point center = block.cluster_bound(c);
        const Lanes radius = Mode::grown(block, p, block.cluster_radius(c));
        if (bridged(squared(center - bound), radius + bound_radius) == 0) continue;
        for (int d = block.first_cluster(q); d < block.end_cluster(q); ++d) {
            const Lanes reach = radius + Mode::grown(block, q, block.cluster_radius(d));
            if (bridged(squared(center - block.cluster_bound(d)), reach) == 0) continue;
            if (clusters_touch(block, pair, c, d, mode)) return true;
        }
    }
    return false;
}

/// Calls `test` with an obstacle.
template <class Test>
inline bool with_solid(const Obstacle& obstacle, const Test& test) {
    switch (obstacle.kind) {
        case sphere:
            return test(Solid<sphere>{obstacle});
        case upright_box:
            return test(Solid<upright_box>{obstacle});
        case box:
            return test(Solid<box>{obstacle});
        case upright_cylinder:
            return test(Solid<upright_cylinder>{obstacle});
        case cylinder:
            return test(Solid<cylinder>{obstacle});
        case capsule:
            return test(Solid<capsule>{obstacle});
    }
    return false;
}

/// Around eight balls.
struct Box {
    Lanes lower[3];
    Lanes upper[3];

    Box(const Point& center, const Lanes& radius)
        : lower{lowest(center.x - radius), lowest(center.y - radius), lowest(center.z - radius)},
          upper{highest(center.x + radius), highest(center.y + radius), highest(center.z + radius)} {}
};

/// Bit i: the box meets that around obstacle i of the block.
inline unsigned meeting(const ObstacleBoxes& boxes, const Box& box) {
    unsigned apart = 0;
    for (int i = 0; i < 3; ++i) {
        const Lanes gap =
            maximum(Lanes::load(boxes.lower[i]) - box.upper[i], box.lower[i] - Lanes::load(boxes.upper[i]));
        apart |= ~not_greater(gap, 0.0F);
    }
    return ~apart & ((1U << kLanes) - 1);
}

/// Calls `test(obstacle)` for all obstacles and grids that a part may touch, until one returns true.
template <class Mode, class Test>
inline bool for_obstacles(const Block& block, int p, const Test& test) {
    const Model& model = block.model();
    const Part& part = model.parts[p];
    if (part.boxes_count > 0) {
        const Box box(block.bound(p), Mode::grown(block, p, block.bound_radius(p)));
        for (int b = part.first_boxes; b < part.first_boxes + part.boxes_count; ++b) {
            for (unsigned left = meeting(model.boxes[b], box); left != 0; left &= left - 1) {
                if (with_solid(model.obstacles[kLanes * b + __builtin_ctz(left)], test)) return true;
            }
        }
    }
    for (int g = part.first_grid; g < part.first_grid + part.grid_count; ++g) {
        if (test(Cells{model.grids[g]})) return true;
    }
    return false;
}

/// All tests of a block.
template <class Mode>
inline unsigned examine(Block& block, Mode mode) {
    const Model& model = block.model();
    for (int p = 0; p < model.part_count; ++p) {
        block.place_bound(p);
        mode.enter(block, p);
        const bool done = for_obstacles<Mode>(
            block, p, [&](const auto& obstacle) { return part_touches(block, p, obstacle, mode); });
        if (done) return mode.hit;
    }
    for (int i = 0; i < model.pair_count; ++i) {
        if (parts_touch(block, model.pairs[i], mode)) return mode.hit;
    }
    return mode.hit;
}

/// Positions at places `t` of a segment.
inline void interpolate(const Model& model, const float* from, const float* change, const Lanes& t,
                        float* positions) {
    for (int v = 0; v < model.variable_count; ++v) {
        multiply_add(change[v], t, from[v]).store(positions + v * kLanes);
    }
}

float sweeps(const Model& model, const float* change, float* result) {
    for (int p = 0; p < model.part_count; p += kLanes) {
        Lanes sum = 0.0F;
        for (int v = 0; v < model.variable_count; ++v) {
            const Lanes lever = Lanes::load(model.levers + v * lever_stride(model.part_count) + p);
            sum = multiply_add(lever, absolute(Lanes(change[v])), sum);
        }
        sum.store(result + p);
    }
    float turn = 0;
    for (int v = 0; v < model.variable_count; ++v) {
        turn += model.turns[v] * (change[v] < 0 ? -change[v] : change[v]);
    }
    return turn;
}

unsigned collisions(const Model& model, const float* positions, float* scratch) {
    Block block(model, scratch);
    block.place(positions);
    return examine(block, Every());
}

unsigned swept_collisions(const Model& model, const float* from, const float* change, const float* t,
                          const float* width, const float* part_sweeps, float turn, float* scratch) {
    alignas(32) float positions[kMaxVariables * kLanes];
    interpolate(model, from, change, Lanes::load(t), positions);
    Block block(model, scratch);
    block.place_moving(positions, change);
    return examine(block, EverySwept{part_sweeps, turn, Lanes::load(width)});
}

bool motion_free(const Model& model, const float* from, const float* change, int rakes, bool with_start,
                 float* scratch) {
    alignas(32) float positions[kMaxVariables * kLanes];
    const int first = with_start ? 0 : 1;
    const float step = 1.0F / static_cast<float>(kLanes * rakes - 1 + first);
    Block block(model, scratch);
    for (int i = 0, turns = rake_turns(rakes); i < turns; ++i) {
        const int rake = rake_at(i, rakes);
        if (rake < 0) continue;
        const Lanes places = multiply_add(Lanes::ascending(), static_cast<float>(rakes) * step,
                                          static_cast<float>(rake + first) * step);
        interpolate(model, from, change, places, positions);
        block.place(positions);
        if (examine(block, Any()) != 0) return false;
    }
    return true;
}

}  // namespace
}  // namespace praxis::tamp::kernel
