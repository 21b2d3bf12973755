#include "tests/app/tasks.hpp"

namespace praxis::test {
namespace {

constexpr int kSide = 5;

std::string square(int row, int column) {
    return "s" + std::to_string(row) + std::to_string(column);
}

}  // namespace

std::string hard_tiles_problem() {
    std::string objects;
    std::string init;
    std::string goal;
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            objects += " " + square(row, column);
            const auto beside = [&](int r, int c) {
                if (r >= 0 && c >= 0 && r < kSide && c < kSide)
                    init += " (beside " + square(row, column) + " " + square(r, c) + ")";
            };
            beside(row - 1, column);
            beside(row + 1, column);
            beside(row, column - 1);
            beside(row, column + 1);
            const int number = row * kSide + column;
            if (number == 0) {
                init += " (hole " + square(row, column) + ")";
                continue;
            }
            const std::string tile = "t" + std::to_string(number);
            objects += " " + tile;
            init += " (tile " + tile + ") (on " + tile + " " + square(row, column) + ")";
            goal += " (on " + tile + " " + square(kSide - 1 - row, kSide - 1 - column) + ")";
        }
    return "(define (problem hard) (:domain tiles) (:objects" + objects + ") (:init" + init +
           ") (:goal (and" + goal + ")))\n";
}

}  // namespace praxis::test
