#include "learned/maps/navigation.hpp"

#include <numeric>
#include <stdexcept>

#include "learned/groups/group.hpp"
#include "learned/layers/uniform.hpp"

namespace praxis::learned {
namespace {

void carve(MapProblem& maze, Random& random) {
    struct Step {
        Offset cell;
        std::vector<int> moves;  // still to try
    };
    const auto open = [&](int row, int column) -> std::uint8_t& {
        return maze.free[static_cast<std::size_t>(row * maze.width + column)];
    };
    const auto step = [&](Offset cell) {
        Step result{cell, {0, 1, 2, 3}};
        random.shuffle(result.moves);
        return result;
    };
    open(1, 1) = 1;
    std::vector<Step> path{step({1, 1})};
    while (!path.empty()) {
        if (path.back().moves.empty()) {
            path.pop_back();
            continue;
        }
        const Offset at = path.back().cell;
        const Offset move = kMoves[static_cast<std::size_t>(path.back().moves.back())];
        path.back().moves.pop_back();
        const int row = at.row + 2 * move.row, column = at.column + 2 * move.column;
        if (row < 0 || row >= maze.height || column < 0 || column >= maze.width || open(row, column))
            continue;
        open(row, column) = open(at.row + move.row, at.column + move.column) = 1;
        path.push_back(step({row, column}));
    }
}

void label(MapProblem& problem, Random& random) {
    problem.label.resize(problem.free.size());
    for (std::size_t cell = 0; cell < problem.label.size(); ++cell) {
        const unsigned moves = problem.optimal[cell] ? problem.optimal[cell] : 15u;
        std::uint8_t& chosen = problem.label[cell];
        do chosen = static_cast<std::uint8_t>(random.below(4));
        while (!(moves >> chosen & 1));
    }
}

}  // namespace

MapProblem navigation_problem(int size, Random& random, double decimation) {
    if (size < 5 || size > 255) throw std::invalid_argument("a maze's size must be 5 to 255");
    MapProblem problem;
    problem.height = problem.width = size;
    problem.free.assign(static_cast<std::size_t>(problem.cells()), 0);
    carve(problem, random);
    const double opened = uniform(random, 0, decimation);
    for (int row = 1; row < size - 1; ++row)
        for (int column = 1; column < size - 1; ++column)
            if (uniform(random) < opened) problem.free[static_cast<std::size_t>(row * size + column)] = 1;
    const auto inner = [&] { return 1 + static_cast<int>(random.below(static_cast<std::size_t>(size - 2))); };
    const int goal_row = inner();
    problem.goal = goal_row * size + inner();
    problem.free[static_cast<std::size_t>(problem.goal)] = 1;
    solve_exactly(problem);
    label(problem, random);
    return problem;
}

MapSet navigation_set(int size, std::size_t count, std::uint64_t seed, double decimation) {
    Random random(seed);
    MapSet set{size, size, {}};
    set.problems.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        set.problems.push_back(navigation_problem(size, random, decimation));
    return set;
}

}  // namespace praxis::learned
