// A map with a goal, and what is known about it: exact distances and every optimal move.
#pragma once

#include <cstdint>
#include <vector>

#include "learned/kernels/edges.hpp"
#include "learned/models/planner.hpp"

namespace praxis::learned {

struct MapProblem {
    static constexpr std::uint16_t kUnreachable = 0xffff;

    int height = 0, width = 0;
    int goal = 0;                         ///< cell row * width + column
    Padding padding = Padding::zero;      ///< circular: moves wrap around
    std::vector<std::uint8_t> free;       ///< of each cell, 1 or 0
    std::vector<std::uint16_t> distance;  ///< moves to the goal, or kUnreachable
    std::vector<std::uint8_t>
        optimal;  ///< bit m: move m of kMoves is on a shortest path; 0 at the goal and off its reach
    std::vector<std::uint8_t>
        label;  ///< one move a cell, as the thesis's data have it: any move where none is optimal

    int cells() const { return height * width; }
    /// The cell that a move leads to, or -1 if it leads into a wall or off the map.
    int neighbour(int cell, int move) const;
};

/// Computes distances and optimal moves by breadth-first search. std::invalid_argument if the goal is not
/// free, the sizes do not agree, or the map has 2^16 - 1 cells or more.
void solve_exactly(MapProblem& problem);

/// Writes map and goal into the input of a trace of the same size.
template <class T>
void draw(const MapProblem& problem, Trace<T>& trace) {
    for (int row = 0; row < problem.height; ++row)
        for (int column = 0; column < problem.width; ++column) {
            const int cell = row * problem.width + column;
            trace.input.at(0, row, column) = static_cast<T>(problem.free[static_cast<std::size_t>(cell)]);
            trace.input.at(1, row, column) = static_cast<T>(cell == problem.goal);
        }
}

/// Maps of one size.
struct MapSet {
    int height = 0, width = 0;
    std::vector<MapProblem> problems;
};

}  // namespace praxis::learned
