#include "learned/maps/maze_file.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "learned/groups/group.hpp"
#include "parser/diagnostic.hpp"

namespace praxis::learned {

MapSet read_mazes(const std::string& file, int size, std::size_t limit) {
    if (size < 1 || size > 255) throw std::invalid_argument("a maze's size must be 1 to 255");
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw InputError(file + ": error: cannot be opened\n");
    const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const std::size_t cells = static_cast<std::size_t>(size * size), record = 2 * cells + 2;
    if (bytes.empty() || bytes.size() % record != 0)
        throw InputError(file + ": error: " + std::to_string(bytes.size()) +
                         " bytes are not a number of records of " + std::to_string(record) +
                         " bytes (mazes of " + std::to_string(size) + " x " + std::to_string(size) + ")\n");
    MapSet set{size, size, {}};
    const std::size_t count = limit ? std::min(limit, bytes.size() / record) : bytes.size() / record;
    for (std::size_t k = 0; k < count; ++k) {
        const auto fail = [&](const std::string& what) {
            throw InputError(file + ": error: record " + std::to_string(k + 1) + ": " + what + "\n");
        };
        const auto* const at = reinterpret_cast<const std::uint8_t*>(bytes.data()) + k * record;
        MapProblem problem;
        problem.height = problem.width = size;
        problem.free.assign(at, at + cells);
        problem.label.assign(at + cells + 2, at + record);
        if (std::ranges::any_of(problem.free, [](std::uint8_t cell) { return cell > 1; }))
            fail("a cell is not 0 or 1");
        if (at[cells] >= size || at[cells + 1] >= size) fail("the goal is off the map");
        problem.goal = at[cells] * size + at[cells + 1];
        if (!problem.free[static_cast<std::size_t>(problem.goal)]) fail("the goal is in a wall");
        solve_exactly(problem);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            if (problem.label[cell] >= kMoves.size()) fail("a label is not 0 to 3");
            if (problem.optimal[cell] && !(problem.optimal[cell] >> problem.label[cell] & 1))
                fail("the label of cell " + std::to_string(cell / static_cast<std::size_t>(size)) + ", " +
                     std::to_string(cell % static_cast<std::size_t>(size)) + " is not an optimal move");
        }
        set.problems.push_back(std::move(problem));
    }
    return set;
}

}  // namespace praxis::learned
