#include "tamp/problems/shelf.hpp"

#include <algorithm>
#include <cmath>

#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

namespace {

constexpr double kTop = 0.3;     ///< height of the bench
constexpr double kTable = 0.2;   ///< height of the tables beside the arm
constexpr double kHalf = 0.33;    ///< half the width of the cell
constexpr double kFront = 0.4;   ///< where the cell begins along x
constexpr double kBack = 0.76;    ///< where it ends
constexpr double kHeight = 0.38;  ///< of the space in the cell
constexpr double kBoard = 0.02;
constexpr double kBench = 0.58;  ///< middle of the bench along x
constexpr double kStick = 0.04;

}  // namespace

std::vector<Board> shelf_boards() {
    // Half a millimetre over the bench.
    const double foot = kTop + 5e-4;
    const double middle = (kFront + kBack) / 2;
    const double depth = kBack - kFront;
    return {
        {"back", {kBoard, 2 * (kHalf + kBoard), kHeight}, {kBack + kBoard / 2, 0, foot + kHeight / 2}},
        {"side1", {depth, kBoard, kHeight}, {middle, kHalf + kBoard / 2, foot + kHeight / 2}},
        {"side2", {depth, kBoard, kHeight}, {middle, -kHalf - kBoard / 2, foot + kHeight / 2}},
        {"roof",
         {depth + kBoard, 2 * (kHalf + kBoard), kBoard},
         {middle + kBoard / 2, 0, foot + kHeight + kBoard / 2}},
    };
}

Board shelf_bench() {
    return {"bench", {0.56, 0.8, 0.1}, {kBench, 0, kTop - 0.05}};
}

ShelfSpace shelf_space() {
    return {{kFront, -kHalf, kTop}, {kBack, kHalf, kTop + kHeight}};
}

void add_shelf_tables(ProblemText& text, const Place& region_size) {
    const Board bench = shelf_bench();
    text.add_box(bench.name, bench.size, bench.center);
    text.add_box("table-left", {0.5, 0.4, 0.1}, {0.05, 0.52, kTable - 0.05});
    text.add_box("table-right", {0.5, 0.4, 0.1}, {0.05, -0.52, kTable - 0.05});
    for (const std::string name : {"bench", "table-left", "table-right"}) text.add_top(name);
    text.add_region("left", "table-left", {0, 0}, region_size);
    text.add_region("right", "table-right", {0, 0}, region_size);
}

void add_shelf_things(ProblemText& text, Random& random, int blockers, double depth) {
    const auto add = [&](const std::string& name, const Place& place, const std::array<double, 3>& color) {
        text.add_thing({.name = name,
                        .shape = box_text({kStick, kStick, 0.2}),
                        .surface = "bench",
                        .place = {place[0] - kBench, place[1]},
                        .color = color,
                        .grasps = "[side]"});
        text.add_fact("(placeable " + name + " left) (placeable " + name + " right)");
    };
    const Place target = {depth, uniform(random, -0.08, 0.08)};
    // The first stands right before the target, the others anywhere in front.
    std::vector<Place> places = {target, {kFront + 0.04 + uniform(random, 0, 0.17), target[1]}};
    // Away from the sides: the hand is wide.
    const ScatterBox space = {{kFront + 0.02, -kHalf + 0.12}, {kBack - 0.13, kHalf - 0.12}};
    const std::vector<Place> others = scatter(random, space, blockers - 1, 0.1, 0.07, places);
    add("target", target, colors::kRed);
    places.insert(places.end(), others.begin(), others.end());
    for (int i = 1; i <= blockers; ++i) {
        add("can" + std::to_string(i), places[static_cast<std::size_t>(i)], colors::kBlue);
    }
}

}  // namespace praxis::tamp
