// Rooms with doors, each with a low table; a mobile robot carries things from table to table. Walls are
// boxes, or voxels of an OctoMap.
#include <octomap/OcTree.h>

#include <sstream>

#include "tamp/problems/floor_plan.hpp"
#include "tamp/problems/scatter.hpp"
#include "tamp/text/number_text.hpp"

namespace praxis::tamp {

namespace {

constexpr double kTable = 0.5;  ///< side of a table
constexpr double kTableHeight = 0.3;

/// Rooms for a number of things: four for six, nine for twenty.
int rooms_a_side(int things) {
    return things < 12 ? 2 : 3;
}

std::string octomap_of(const std::vector<Wall>& walls) {
    constexpr double kEdge = 0.05;
    octomap::OcTree tree(kEdge);
    for (const Wall& wall : walls) {
        const auto steps = [&](std::size_t axis) { return static_cast<int>(wall.size[axis] / kEdge + 0.5); };
        const auto at = [&](std::size_t axis, int step) {
            return static_cast<float>(wall.center[axis] - wall.size[axis] / 2 + (step + 0.5) * kEdge);
        };
        for (int x = 0; x < steps(0); ++x) {
            for (int y = 0; y < steps(1); ++y) {
                for (int z = 0; z < steps(2); ++z) {
                    tree.updateNode(octomap::point3d(at(0, x), at(1, y), at(2, z)), true, true);
                }
            }
        }
    }
    tree.updateInnerOccupancy();
    tree.toMaxLikelihood();
    tree.prune();
    // As `writeBinary` does, which talks on the terminal.
    std::ostringstream bytes;
    bytes << "# Octomap OcTree binary file\nid " << tree.getTreeType() << "\nsize " << tree.size() << "\nres "
          << shortest(kEdge) << "\ndata\n";
    tree.writeBinaryData(bytes);
    return bytes.str();
}

GeneratedProblem make_rooms(ProblemRequest request, bool octomap) {
    Random& random = request.random;
    const int side = rooms_a_side(request.size);
    const FloorPlan plan = make_floor_plan(random, {.side = side, .room = 3, .door = 1.1});
    const Place start = plan.center(0);
    ProblemText text("pick-place", request.name,
                     std::to_string(request.size) + " things in " + std::to_string(side * side) +
                         " rooms; half of them have to go to another room.",
                     "mobile-arm7", start_text(start));
    if (octomap) {
        text.add_file("walls.bt", octomap_of(plan.walls));
        text.add_fixed("walls", "octomap: {file: walls.bt, unknown: free}");
    } else {
        for (const Wall& wall : plan.walls) text.add_box(wall.name, wall.size, wall.center, colors::kWall);
    }
    const int rooms = side * side;
    for (int room = 0; room < rooms; ++room) {
        const std::string table = "table" + std::to_string(room + 1);
        // In a corner region away from the doors, which are in the middle of walls.
        const Place middle = plan.center(room);
        const double dx = random.below(2) == 0 ? -0.75 : 0.75;
        const double dy = random.below(2) == 0 ? -0.75 : 0.75;
        text.add_box(table, {kTable, kTable, kTableHeight},
                     {middle[0] + dx, middle[1] + dy, kTableHeight / 2});
        text.add_top(table);
        text.add_region("on-" + table, table, {0, 0}, {kTable - 0.02, kTable - 0.02});
    }
    std::vector<std::vector<Place>> taken(static_cast<std::size_t>(rooms));
    for (int i = 0; i < request.size; ++i) {
        const auto room = static_cast<std::size_t>(i % rooms);
        const std::string name = "thing" + std::to_string(i + 1);
        const Place at = scatter(random, {{-0.2, -0.2}, {0.2, 0.2}}, 1, 0.15, 0.1, taken[room])[0];
        taken[room].push_back(at);
        text.add_thing({.name = name,
                        .shape = cylinder_text(0.03, 0.15),
                        .surface = "table" + std::to_string(room + 1),
                        .place = at,
                        .color = i % 2 == 0 ? colors::kRed : colors::kBlue});
        if (i % 2 != 0) continue;
        const std::size_t other =
            (room + 1 + random.below(static_cast<std::size_t>(rooms) - 1)) % static_cast<std::size_t>(rooms);
        const std::string goal = "on-table" + std::to_string(other + 1);
        text.add_fact("(placeable " + name + " " + goal + ")");
        text.add_goal("(in " + name + " " + goal + ")");
    }
    return std::move(text).finish();
}

}  // namespace

GeneratedProblem rooms(ProblemRequest request) {
    return make_rooms(std::move(request), false);
}

GeneratedProblem rooms_octomap(ProblemRequest request) {
    return make_rooms(std::move(request), true);
}

}  // namespace praxis::tamp
