// Sticks of four colours that stand close together before the arm; each has to go to the region of its
// colour. In the twin one stick is in a cage, or its region is too small or out of reach.
#include "tamp/problems/families.hpp"
#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

namespace {

struct Color {
    std::string name;
    std::array<double, 3> color;
    std::string table;
    Place center;  ///< of its region, on the table
};

const std::vector<Color>& stick_colors() {
    static const std::vector<Color> all = {{"red", colors::kRed, "table-left", {-0.2, -0.03}},
                                           {"green", colors::kGreen, "table-left", {0.2, -0.03}},
                                           {"blue", colors::kBlue, "table-right", {-0.2, 0.03}},
                                           {"yellow", colors::kYellow, "table-right", {0.2, 0.03}}};
    return all;
}

/// Four walls and a lid that leave no way to a stick.
void add_cage(ProblemText& text, const Place& at) {
    constexpr double kSide = 0.08;
    constexpr double kTop = 0.05;
    const double z = kTop + 0.13;
    text.add_box("cage1", {0.01, kSide, 0.26}, {at[0] - kSide / 2, at[1], z}, colors::kGrey);
    text.add_box("cage2", {0.01, kSide, 0.26}, {at[0] + kSide / 2, at[1], z}, colors::kGrey);
    text.add_box("cage3", {kSide, 0.01, 0.26}, {at[0], at[1] - kSide / 2, z}, colors::kGrey);
    text.add_box("cage4", {kSide, 0.01, 0.26}, {at[0], at[1] + kSide / 2, z}, colors::kGrey);
    text.add_box("lid", {kSide + 0.02, kSide + 0.02, 0.01}, {at[0], at[1], kTop + 0.27}, colors::kGrey);
}

}  // namespace

GeneratedProblem clutter(ProblemRequest request) {
    enum class Twin { none, caged, narrow, far };
    Random& random = request.random;
    const Twin twin = request.feasible ? Twin::none : static_cast<Twin>(1 + random.below(3));
    ProblemText text("pick-place", request.name,
                     std::to_string(request.size) + " sticks have to be sorted by colour.");
    const Place table = {0.58, 0};
    text.add_box("bench", {0.6, 0.9, 0.1}, {table[0], table[1], 0});
    text.add_box("table-left", {0.8, 0.36, 0.1}, {0.1, 0.65, 0});
    text.add_box("table-right", {0.8, 0.36, 0.1}, {0.1, -0.65, 0});
    for (const std::string name : {"bench", "table-left", "table-right"}) text.add_top(name);
    if (twin == Twin::far) {
        text.add_box("far-table", {0.4, 0.4, 0.1}, {1.5, 0, 0});
        text.add_top("far-table");
    }
    for (const Color& color : stick_colors()) {
        const bool odd = color.name == "red";
        if (odd && twin == Twin::far) {
            text.add_region(color.name, "far-table", {0, 0}, {0.36, 0.3});
        } else {
            const bool narrow = odd && twin == Twin::narrow;
            text.add_region(color.name, color.table, color.center,
                            narrow ? Place{0.03, 0.03} : Place{0.36, 0.28});
        }
    }
    const ScatterBox space = {{0.33, -0.4}, {0.72, 0.4}};
    const std::vector<Place> places = twin == Twin::caged ? scatter(random, space, request.size - 1, 0.1,
                                                                    0.07, {{0.5, 0}, {0.56, 0}, {0.44, 0}})
                                                          : scatter(random, space, request.size, 0.1, 0.07);
    for (int i = 0; i < request.size; ++i) {
        const bool caged = twin == Twin::caged && i == 0;
        const std::size_t number = static_cast<std::size_t>(twin == Twin::caged ? i - 1 : i);
        const Place at = caged ? Place{0.5, 0} : places[number];
        const std::string name = "stick" + std::to_string(i + 1);
        const Color& color = stick_colors()[static_cast<std::size_t>(i) % stick_colors().size()];
        text.add_thing({.name = name,
                        .shape = box_text({0.04, 0.04, 0.2}),
                        .surface = "bench",
                        .place = {at[0] - table[0], at[1] - table[1]},
                        .yaw = caged ? 0 : uniform(random, -0.7, 0.7),
                        .color = color.color});
        text.add_fact("(placeable " + name + " " + color.name + ")");
        text.add_goal("(in " + name + " " + color.name + ")");
        if (caged) add_cage(text, at);
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
