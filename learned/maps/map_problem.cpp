#include "learned/maps/map_problem.hpp"

#include <stdexcept>

#include "learned/groups/group.hpp"

namespace praxis::learned {

int MapProblem::neighbour(int cell, int move) const {
    int row = cell / width + kMoves[static_cast<std::size_t>(move)].row;
    int column = cell % width + kMoves[static_cast<std::size_t>(move)].column;
    if (padding == Padding::circular) {
        row = (row + height) % height;
        column = (column + width) % width;
    } else if (row < 0 || row >= height || column < 0 || column >= width) {
        return -1;
    }
    const int next = row * width + column;
    return free[static_cast<std::size_t>(next)] ? next : -1;
}

void solve_exactly(MapProblem& problem) {
    const std::size_t cells = problem.free.size();
    if (problem.height < 1 || problem.width < 1 || static_cast<int>(cells) != problem.cells() ||
        cells >= MapProblem::kUnreachable)
        throw std::invalid_argument("a map needs height x width cells, fewer than 65535");
    if (problem.goal < 0 || problem.goal >= problem.cells() ||
        !problem.free[static_cast<std::size_t>(problem.goal)])
        throw std::invalid_argument("the goal of a map must be one of its free cells");
    problem.distance.assign(cells, MapProblem::kUnreachable);
    problem.optimal.assign(cells, 0);
    std::vector<int> queue{problem.goal};
    queue.reserve(cells);
    problem.distance[static_cast<std::size_t>(problem.goal)] = 0;
    for (std::size_t head = 0; head < queue.size(); ++head) {
        const int cell = queue[head];
        const int distance = problem.distance[static_cast<std::size_t>(cell)];
        for (int move = 0; move < 4; ++move) {
            const int next = problem.neighbour(cell, move);
            if (next < 0) continue;
            std::uint16_t& known = problem.distance[static_cast<std::size_t>(next)];
            if (known == distance - 1)
                problem.optimal[static_cast<std::size_t>(cell)] |= static_cast<std::uint8_t>(1 << move);
            if (known != MapProblem::kUnreachable) continue;
            known = static_cast<std::uint16_t>(distance + 1);
            queue.push_back(next);
        }
    }
}

}  // namespace praxis::learned
