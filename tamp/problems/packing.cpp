// Pieces that just fit into a tray, in cells side by side. They are of different heights: fingers have room
// beside a piece only where its neighbours are lower, or not there yet. The tray of the twin is a row of
// cells too small.
#include <algorithm>

#include "tamp/problems/families.hpp"
#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

GeneratedProblem packing(ProblemRequest request) {
    constexpr double kCell = 0.065;
    constexpr double kRim = 0.01;
    Random& random = request.random;
    const int pieces = request.size;
    const int rows = pieces <= 3 ? 1 : 2;
    const int columns = (pieces + rows - 1) / rows - (request.feasible ? 0 : 1);
    const Place inside = {rows * kCell, columns * kCell};
    ProblemText text("pick-place", request.name,
                     std::to_string(pieces) + " pieces have to be packed into a tray.");
    text.add_box("bench", {0.5, 0.9, 0.1}, {0.58, 0, 0});
    text.add_box("table-left", {0.5, 0.5, 0.1}, {0.1, 0.6, 0});
    text.add_top("bench");
    text.add_top("table-left");
    text.add_region("tray", "table-left", {0.1, -0.05}, inside);
    const Place tray = {0.2, 0.55};
    const double z = 0.05 + 5e-4 + 0.01;
    for (const double side : {-1.0, 1.0}) {
        const std::string suffix = side < 0 ? "1" : "2";
        text.add_box("rim-x" + suffix, {kRim, inside[1] + 2 * kRim, 0.02},
                     {tray[0] + side * (inside[0] + kRim) / 2, tray[1], z});
        text.add_box("rim-y" + suffix, {inside[0], kRim, 0.02},
                     {tray[0], tray[1] + side * (inside[1] + kRim) / 2, z});
    }
    const std::vector<Place> places = scatter(random, {{-0.2, -0.35}, {0.13, 0.3}}, pieces, 0.18, 0.12);
    std::vector<int> heights;
    for (int i = 0; i < pieces; ++i) heights.push_back(i);
    random.shuffle(heights);
    for (int i = 0; i < pieces; ++i) {
        const auto number = static_cast<std::size_t>(i);
        const std::string name = "piece" + std::to_string(i + 1);
        text.add_thing({.name = name,
                        .shape = box_text({uniform(random, 0.05, 0.058), uniform(random, 0.05, 0.058),
                                           0.06 + 0.035 * heights[number]}),
                        .surface = "bench",
                        .place = places[number],
                        .color = i % 2 == 0 ? colors::kYellow : colors::kGreen});
        text.add_fact("(placeable " + name + " tray)");
        text.add_goal("(in " + name + " tray)");
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
