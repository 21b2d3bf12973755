#include "tamp/problems/shelf.hpp"

#include <algorithm>

namespace praxis::tamp {

namespace {

constexpr double kTop = 0.3;      ///< height of the bench
constexpr double kTable = 0.2;    ///< height of the tables beside the arm
constexpr double kHalf = 0.33;    ///< half the width of the cell
constexpr double kFront = 0.43;   ///< where the cell begins along x
constexpr double kBack = 0.79;    ///< where it ends
constexpr double kHeight = 0.38;  ///< of the space in the cell
constexpr double kBoard = 0.02;
constexpr double kBench = 0.61;  ///< middle of the bench along x
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
    text.add_box("table-behind", {0.4, 0.9, 0.1}, {-0.5, 0, kTable - 0.05});
    for (const std::string name : {"bench", "table-left", "table-right", "table-behind"}) text.add_top(name);
    text.add_region("left", "table-left", {0, 0}, region_size);
    text.add_region("right", "table-right", {0, 0}, region_size);
    text.add_region("behind", "table-behind", {0, 0}, {0.36, 0.8});
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
        text.add_fact("(placeable " + name + " behind)");
    };
    // Three rows of five before the target, a hand's width apart, a little disturbed; the first blocker
    // stands in the target's column.
    constexpr int kRows = 3;
    constexpr int kColumns = 5;
    const auto at = [&](int row, double column) -> Place {
        return {kFront + 0.03 + 0.075 * row + uniform(random, -0.006, 0.006),
                0.085 * (column - kColumns / 2) + uniform(random, -0.004, 0.004)};
    };
    const int column = 1 + static_cast<int>(random.below(kColumns - 2));
    const Place target = {depth, at(0, column)[1]};
    std::vector<int> slots;
    for (int slot = 0; slot < kRows * kColumns; ++slot) slots.push_back(slot);
    random.shuffle(slots);
    const auto first = std::ranges::find(slots, column, [](int slot) { return slot % kColumns; });
    std::iter_swap(slots.begin(), first);
    std::vector<Place> places = {target};
    for (int i = 0; i < blockers; ++i) {
        const int slot = slots[static_cast<std::size_t>(i)];
        places.push_back(at(slot / kColumns, slot % kColumns));
    }
    add("target", target, colors::kRed);
    for (int i = 1; i <= blockers; ++i) {
        add("can" + std::to_string(i), places[static_cast<std::size_t>(i)], colors::kBlue);
    }
}

}  // namespace praxis::tamp
