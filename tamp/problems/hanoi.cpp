// The towers of Hanoi: discs of equal height and different width, moved with an arm. Towers stand so close
// that some grasps do not fit beside a higher one. Poses are known: one a place and level.
#include <array>

#include "tamp/problems/families.hpp"
#include "tamp/problems/problem_text.hpp"

namespace praxis::tamp {

GeneratedProblem hanoi(ProblemRequest request) {
    constexpr double kGap = 5e-4;
    constexpr double kHeight = 0.03;
    constexpr double kWidest = 0.038;
    constexpr double kApart = 0.13;
    Random& random = request.random;
    const int discs = request.size;
    ProblemText text("hanoi", request.name,
                     "The towers of Hanoi with " + std::to_string(discs) + " discs, at least " +
                         std::to_string((1 << discs) - 1) + " moves.");
    const double x = 0.5 + uniform(random, -0.03, 0.03);
    const double shift = uniform(random, -0.05, 0.05);
    text.add_box("bench", {0.6, 0.9, 0.1}, {0.58, 0, 0});
    const std::array<std::string, 3> pegs = {"a", "b", "c"};
    std::array<std::array<double, 2>, 3> centers = {};
    for (std::size_t peg = 0; peg < 3; ++peg) {
        centers[peg] = {x, shift + kApart * (static_cast<double>(peg) - 1)};
        text.add_cylinder("pad-" + pegs[peg], 0.045, 0.01, {centers[peg][0], centers[peg][1], 0.055});
    }
    const auto position = [&](std::size_t peg, int level) -> Size3 {
        return {centers[peg][0], centers[peg][1], 0.06 + kGap + kHeight / 2 + (level - 1) * (kHeight + kGap)};
    };
    const auto slot = [&](std::size_t peg, int level) { return pegs[peg] + std::to_string(level); };
    const std::size_t from = random.below(3);
    const std::size_t to = (from + 1 + random.below(2)) % 3;
    for (std::size_t peg = 0; peg < 3; ++peg) {
        for (int level = 1; level <= discs + 1; ++level) {
            text.add_pose(slot(peg, level), position(peg, level));
            if (level > discs || peg != from) text.add_fact("(empty " + slot(peg, level) + ")");
            if (level > 1) text.add_fact("(above " + slot(peg, level) + " " + slot(peg, level - 1) + ")");
        }
        text.add_fact("(bottom " + slot(peg, 1) + ")");
    }
    // Disc 1 is the smallest.
    for (int disc = discs; disc >= 1; --disc) {
        const std::string name = "disc" + std::to_string(disc);
        const int level = discs - disc + 1;
        text.add_thing({.name = name,
                        .shape = cylinder_text(kWidest - 0.003 * (discs - disc), kHeight),
                        .pose = {{slot(from, level), position(from, level)}},
                        .color = disc % 2 == 0 ? colors::kBlue : colors::kYellow,
                        .grasps = "[top]"});
        for (int wider = disc + 1; wider <= discs; ++wider) {
            text.add_fact("(smaller " + name + " disc" + std::to_string(wider) + ")");
        }
        text.add_goal("(at " + name + " " + slot(to, level) + ")");
        for (std::size_t peg = 0; peg < 3; ++peg) {
            for (int other = 1; other <= level; ++other) {
                if (peg == from && other == level) continue;
                text.add_fact("(pose-of " + name + " " + slot(peg, other) + ")");
            }
        }
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
