// A cell of a shelf in front of the arm, open to its side, with a target behind blockers, and tables on both
// sides of the arm and behind it.
#pragma once

#include <string>
#include <vector>

#include "tamp/problems/families.hpp"
#include "tamp/problems/problem_text.hpp"

namespace praxis::tamp {

/// One board of the shelf.
struct Board {
    std::string name = {};
    Size3 size = {};
    Size3 center = {};
};

/// Boards of the cell; the shelf stands on the table `bench`.
std::vector<Board> shelf_boards();

/// The box of the bench.
Board shelf_bench();

/// Bounds of the space within the boards.
struct ShelfSpace {
    Size3 lower = {};
    Size3 upper = {};
};
ShelfSpace shelf_space();

/// The bench under the shelf and the other tables, with the regions `left`, `right` and `behind`.
void add_shelf_tables(ProblemText& text, const Place& region_size = {0.46, 0.36});

/// The target `target` at the back and `blockers` before it, named `can1`, `can2`, ...; all may be put
/// on every table. `depth` is where the target stands along x, in the world.
void add_shelf_things(ProblemText& text, Random& random, int blockers, double depth);

}  // namespace praxis::tamp
