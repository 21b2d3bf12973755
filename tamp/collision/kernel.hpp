// The inner loop of the fast checker: forward kinematics and collision tests of eight configurations at a
// time, on plain floats.
//
// The model is a flat view of a kinematic tree and of what surrounds it, read at run time (no code is made
// for a robot). *Frames* are the frames of joints that the group moves, parents first, each turned so that
// the axis is its z; fixed joints are folded into them. A *part* is a rigid set of balls in one frame: a link
// or an attached body (or several that move together and may touch the same), with a ball around it, and
// balls around *clusters* of its balls. Every part has its own list of the *obstacles* that it may reach and
// must not touch, by kind, and parts are paired with the parts that they must not touch. Tests of a ball
// against an obstacle are exact up to rounding; the radii carry the margin for that
// (`kernel_model.hpp`).
//
// Two sets of functions come from one template (`kernel_template.hpp`): for AVX2 with FMA, and for any
// processor. `kernel_functions()` asks the processor which. This header and those files include neither Eigen
// nor the standard library's inline code, so that nothing compiled for AVX2 can leak into other translation
// units.
#pragma once

namespace praxis::tamp::kernel {

/// Configurations that are looked at together.
inline constexpr int kLanes = 8;

struct Ball {
    float center[3];
    float radius;
};

struct Frame {
    int parent;     ///< frame, or -1: the world
    int variable;   ///< of the group
    int prismatic;  ///< slides along z; otherwise turns about z
    float multiplier;
    float offset;
    float rotation[9];  ///< row by row: of this frame at position 0 in its parent
    float translation[3];
    int by_quarters;  ///< rotation by quarter turns: axis i is, in the parent, sign[i] times axis source[i]
    int source[3];
    float sign[3];
};

/// `upright` means: local z is the world's z.
enum ObstacleKind { sphere, upright_box, box, upright_cylinder, cylinder, capsule };

struct Obstacle {
    ObstacleKind kind;
    float center[3];
    float axes[9];  ///< row i: local axis i in the world
    float size[3];  ///< box: half sides; others: radius, half length
};

/// Boxes along the world's axes around eight obstacles; where there is none the box is turned inside out, so
/// that it meets nothing. Aligned to 32 bytes.
struct alignas(32) ObstacleBoxes {
    float lower[3][kLanes];
    float upper[3][kLanes];
};

/// Distances to what is occupied, by cells; outside of the box nothing is.
struct Grid {
    float axes[9];          ///< row i: axis i of the grid in the world
    float corner[3];        ///< position of the grid's corner along its axes
    float edge;             ///< of a cell
    int cells[3];           ///< along each axis; x runs fastest
    const float* distance;  ///< lower bound for every point of the cell
    float slack;            ///< above 0: added to that it makes an upper bound, which is wanted
};

/// Some balls of a part that are close together.
struct Cluster {
    Ball bound;
    int first_ball;
    int ball_count;
};

struct Part {
    int frame;  ///< or -1: the world
    Ball bound;
    float spread;  ///< of the centres of its balls, from that of the bound
    int first_cluster;
    int cluster_count;
    int first_boxes;  ///< block of obstacles; obstacle i of block b is number 8 b + i
    int boxes_count;
    int first_grid;
    int grid_count;
};

struct PartPair {
    int first;
    int second;
};

struct Model {
    int variable_count;
    int frame_count;
    int part_count;
    int cluster_count;
    int pair_count;
    const Frame* frames;
    const Part* parts;
    const Cluster* clusters;
    const Ball* balls;
    const Obstacle* obstacles;
    const ObstacleBoxes* boxes;
    const Grid* grids;
    const PartPair* pairs;
    /// For each variable of the group, and then for each part (padded to `lever_stride`): at least the metres
    /// that a ball's centre of the part moves for a radian or metre of the variable; twice that for slides
    /// that others turn. Aligned to 32 bytes.
    const float* levers;
    /// For each variable: at least the radians that a frame turns for a radian or metre of it.
    const float* turns;
};

/// Limits of a model: parts, and variables of a group.
inline constexpr int kMaxParts = 256;
inline constexpr int kMaxVariables = 16;

static inline int lever_stride(int part_count) {
    return (part_count + kLanes - 1) / kLanes * kLanes;
}

/// Floats of scratch memory that the functions need, to be aligned to 32 bytes.
int scratch_size(const Model& model);

struct Functions {
    const char* name;

    /// Bit i: configuration i collides. `positions`: eight numbers a variable, variable by variable.
    unsigned (*collisions)(const Model& model, const float* positions, float* scratch);

    /// No collision at 8 * rakes configurations, evenly spaced on the segment that begins at `from` and leads
    /// by `change` to its end: with the end, and with `from` itself if `with_start`. A rake is eight
    /// configurations spread over the whole segment.
    bool (*motion_free)(const Model& model, const float* from, const float* change, int rakes,
                        bool with_start, float* scratch);

    /// Of every part (`lever_stride` of them), an upper bound on how far any of its balls moves over a
    /// segment. Returns one on how far any frame turns.
    float (*sweeps)(const Model& model, const float* change, float* result);

    /// Bit i: the segment may collide at a place between t[i] - width[i] and t[i] + width[i] (as parts of
    /// it). A bit that is not set is a proof: every ball was grown by how far it can get within the stretch,
    /// given its speed in the middle and a bound on its acceleration. `sweeps` and `turn` are what the
    /// function above has found.
    unsigned (*swept_collisions)(const Model& model, const float* from, const float* change, const float* t,
                                 const float* width, const float* sweeps, float turn, float* scratch);

    /// Place of the point that is nearest to `query` (the first of those), and the square of its distance.
    /// Points come in blocks of eight, aligned to 32 bytes: eight numbers of the first coordinate, eight of
    /// the second, and so on. Coordinates with a period (above 0) are compared modulo it; `periods` may be
    /// null.
    int (*nearest)(const float* blocks, int block_count, int dimension, const float* query,
                   const float* periods, float* squared);
};

/// Rakes are looked at in the order i = 0, 1, ..., so that neighbours come late: which one at the i-th turn
/// (-1: none), of `rake_turns` turns. Static, so that every translation unit has its own.
static inline int rake_turns(int rakes) {
    int turns = 1;
    while (turns < rakes) turns *= 2;
    return turns;
}
static inline int rake_at(int i, int rakes) {
    int mirrored = 0;
    for (int bit = 1; bit < rakes; bit *= 2) mirrored = 2 * mirrored + ((i & bit) != 0 ? 1 : 0);
    return mirrored < rakes ? rakes - 1 - mirrored : -1;
}

/// The best functions that this processor can run.
const Functions& functions();
/// For any processor.
const Functions& portable_functions();

}  // namespace praxis::tamp::kernel
