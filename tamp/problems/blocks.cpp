// Blocks that are stacked at first, and have to be stacked in another way: towers of three, each on a site of
// its own. One site is out of the arm's reach, which the task does not know.
#include <algorithm>
#include <vector>

#include "tamp/problems/families.hpp"
#include "tamp/problems/scatter.hpp"

namespace praxis::tamp {

namespace {

constexpr double kSide = 0.05;

std::string block_name(int block) {
    return "block" + std::to_string(block + 1);
}

/// Random towers of one to three blocks on the bench; says which block stands on which (-1: on the bench).
std::vector<int> stack_up(Random& random, int count) {
    std::vector<int> below(static_cast<std::size_t>(count), -1);
    int height = 1;
    for (int block = 1; block < count; ++block) {
        if (height < 3 && random.below(2) == 0) {
            below[static_cast<std::size_t>(block)] = block - 1;
            ++height;
        } else {
            height = 1;
        }
    }
    return below;
}

}  // namespace

GeneratedProblem blocks(ProblemRequest request) {
    constexpr int kTower = 3;
    Random& random = request.random;
    const int towers = request.size / kTower;
    ProblemText text("blocks", request.name,
                     std::to_string(request.size) + " blocks have to be stacked to " +
                         std::to_string(towers) + " towers; one of the sites is out of reach.");
    text.add_box("bench", {0.5, 0.7, 0.1}, {0.55, 0, 0});
    text.add_box("table-left", {0.6, 0.4, 0.1}, {0.1, 0.6, 0});
    text.add_box("table-right", {0.6, 0.4, 0.1}, {0.1, -0.6, 0});
    text.add_box("far-table", {0.3, 0.3, 0.1}, {1.4, 0, 0});
    for (const std::string name : {"bench", "table-left", "table-right", "far-table"}) text.add_top(name);
    text.add_region("middle", "bench", {-0.03, 0}, {0.4, 0.6});
    text.add_region("site-far", "far-table", {0, 0}, {0.08, 0.08});
    std::vector<std::string> sites = {"site-far"};
    for (int i = 0; i < towers; ++i) {
        sites.push_back("site" + std::to_string(i + 1));
        const bool left = i % 2 == 0;
        text.add_region(sites.back(), left ? "table-left" : "table-right",
                        {i < 2 ? 0.1 : -0.1, left ? -0.08 : 0.08}, {0.08, 0.08});
    }
    for (const std::string& site : sites) text.add_fact("(site " + site + ")");

    const std::vector<int> below = stack_up(random, request.size);
    const auto stacks = static_cast<int>(std::ranges::count(below, -1));
    const std::vector<Place> places = scatter(random, {{-0.19, -0.28}, {0.13, 0.28}}, stacks, 0.16, 0.1);
    std::size_t stack = 0;
    for (int block = 0; block < request.size; ++block) {
        const int under = below[static_cast<std::size_t>(block)];
        const std::string name = block_name(block);
        const bool covered = block + 1 < request.size && below[static_cast<std::size_t>(block) + 1] == block;
        if (covered) text.add_top("top-" + name, name);
        text.add_thing({.name = name,
                        .shape = box_text({kSide, kSide, kSide}),
                        .surface = under < 0 ? "bench" : "top-" + block_name(under),
                        .place = under < 0 ? places[stack++] : Place{0, 0},
                        .color = block % 2 == 0 ? colors::kRed : colors::kGreen,
                        .grasps = "[top]"});
        text.add_fact("(placeable " + name + " middle)");
        text.add_fact(under < 0 ? "(on-table " + name + ")" : "(on " + name + " " + block_name(under) + ")");
        if (!covered) text.add_fact("(clear " + name + ")");
    }
    std::vector<int> order;
    for (int block = 0; block < request.size; ++block) order.push_back(block);
    random.shuffle(order);
    for (int tower = 0; tower < towers; ++tower) {
        const auto member = [&](int level) {
            return block_name(order[static_cast<std::size_t>(kTower * tower + level)]);
        };
        for (const std::string& site : sites) text.add_fact("(placeable " + member(0) + " " + site + ")");
        text.add_goal("(sited " + member(0) + ")");
        for (int level = 1; level < kTower; ++level) {
            text.add_fact("(stackable " + member(level) + " " + member(level - 1) + ")");
            text.add_goal("(on " + member(level) + " " + member(level - 1) + ")");
        }
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
