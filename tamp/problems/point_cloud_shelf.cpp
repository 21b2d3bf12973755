// The blocked shelf as a depth camera saw it when it was empty: a noisy cloud of points, a few of them far
// off, and space that was never seen, which counts as occupied.
#include <cmath>
#include <limits>

#include "tamp/problems/shelf.hpp"
#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

constexpr Size3 kSensor = {0.05, 0, 0.47};

/// Where a ray from the sensor first meets a box, as a multiple of the direction; infinity: nowhere.
double meets(const Size3& direction, const Size3& size, const Size3& center) {
    double enter = 0;
    double leave = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0) {
            if (std::abs(kSensor[axis] - center[axis]) > size[axis] / 2) return leave;
            continue;
        }
        const double first = (center[axis] - size[axis] / 2 - kSensor[axis]) / direction[axis];
        const double second = (center[axis] + size[axis] / 2 - kSensor[axis]) / direction[axis];
        enter = std::max(enter, std::min(first, second));
        leave = std::min(leave, std::max(first, second));
    }
    return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

/// Points that the sensor sees, one a line.
std::string scan(Random& random) {
    constexpr int kColumns = 121;
    constexpr int kRows = 81;
    constexpr double kNoise = 0.004;
    std::string text;
    for (int column = 0; column < kColumns; ++column) {
        for (int row = 0; row < kRows; ++row) {
            const Size3 direction = {1, 2.4 * column / (kColumns - 1) - 1.2, 1.1 * row / (kRows - 1) - 0.45};
            double distance = meets(direction, shelf_bench().size, shelf_bench().center);
            for (const Board& board : shelf_boards()) {
                distance = std::min(distance, meets(direction, board.size, board.center));
            }
            if (!std::isfinite(distance)) continue;
            // The mean of four has a third of the spread of one.
            double noise = 0;
            for (int i = 0; i < 4; ++i) noise += uniform(random, -kNoise, kNoise) / 2;
            if (random.below(200) == 0) noise = uniform(random, -0.5, 0) * distance;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double at = kSensor[axis] + (distance + noise) * direction[axis];
                text += (axis > 0 ? " " : "") + shortest(std::round(at * 1e4) / 1e4);
            }
            text += '\n';
        }
    }
    return text;
}

}  // namespace

GeneratedProblem point_cloud_shelf(ProblemRequest request) {
    ProblemText text("pick-place", request.name,
                     "A target behind " + std::to_string(request.size) +
                         " blockers in a cell of a shelf that is known as a cloud of points only.");
    text.add_file("shelf.xyz", scan(request.random));
    // What the cloud tells begins over the bench, which is known.
    text.add_fixed("shelf",
                   "points: {file: shelf.xyz, edge: 0.02, sensor: [0.05, 0, 0.47], least_points: 2, bounds: "
                   "[[0.41, -0.36, 0.34], [0.83, 0.36, 0.74]]}");
    add_shelf_tables(text);
    add_shelf_things(text, request.random, request.size, shelf_space().upper[0] - 0.08);
    text.add_goal("(in target right)");
    return std::move(text).finish();
}

}  // namespace praxis::tamp
