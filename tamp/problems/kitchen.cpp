// Food has to be washed at the sink, cooked on the stove, and served; cups have to be washed. What is done at
// the sink and on the stove has no geometry, but where the food stands has.
#include "tamp/problems/families.hpp"
#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

GeneratedProblem kitchen(ProblemRequest request) {
    Random& random = request.random;
    const int cups = (request.size + 1) / 2;
    ProblemText text("kitchen", request.name,
                     "Cook and serve " + std::to_string(request.size) + " pieces of food, wash " +
                         std::to_string(cups) + " cups.");
    text.add_box("counter", {0.5, 0.8, 0.1}, {0.58, 0, 0});
    text.add_box("table-left", {0.6, 0.5, 0.1}, {0.1, 0.65, 0});
    text.add_box("table-right", {0.6, 0.5, 0.1}, {0.1, -0.65, 0});
    // A hood over the stove: the arm has to stay under it or keep beside it.
    text.add_box("hood", {0.3, 0.3, 0.02}, {0.1, 0.65, 0.56}, colors::kGrey);
    for (const std::string name : {"counter", "table-left", "table-right"}) text.add_top(name);
    text.add_region("shelf", "counter", {0, 0}, {0.42, 0.7});
    text.add_region("stove", "table-left", {0, -0.1}, {0.14, 0.14});
    text.add_region("sink", "table-right", {-0.12, 0.1}, {0.14, 0.14});
    text.add_region("plate", "table-right", {0.15, 0.05}, {0.22, 0.3});
    text.add_fact("(stove stove)");
    text.add_fact("(sink sink)");
    const std::vector<Place> places =
        scatter(random, {{-0.2, -0.33}, {0.15, 0.33}}, request.size + cups, 0.12, 0.085);
    for (int i = 0; i < request.size + cups; ++i) {
        const bool food = i < request.size;
        const std::string name =
            food ? "food" + std::to_string(i + 1) : "cup" + std::to_string(i - request.size + 1);
        text.add_thing(
            {.name = name,
             .shape = food ? box_text({0.045, 0.045, uniform(random, 0.05, 0.1)}) : cylinder_text(0.03, 0.1),
             .surface = "counter",
             .place = places[static_cast<std::size_t>(i)],
             .color = food ? colors::kRed : colors::kBlue});
        for (const std::string place : {"shelf", "sink"}) {
            text.add_fact("(placeable " + name + " " + place + ")");
        }
        if (food) {
            text.add_fact("(placeable " + name + " stove) (placeable " + name + " plate)");
            text.add_goal("(cooked " + name + ") (in " + name + " plate)");
        } else {
            text.add_goal("(clean " + name + ") (in " + name + " shelf)");
        }
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
