// The target has to go to the table on the right, and every blocker has to stand where it stood at first:
// what is moved must be moved again.
#include "tamp/problems/shelf.hpp"

namespace praxis::tamp {

GeneratedProblem non_monotonic(ProblemRequest request) {
    ProblemText text("pick-place", request.name,
                     "A target behind " + std::to_string(request.size) +
                         " blockers, which must stand where they stood at first.");
    for (const Board& board : shelf_boards()) text.add_box(board.name, board.size, board.center);
    add_shelf_tables(text);
    add_shelf_things(text, request.random, request.size, shelf_space().upper[0] - 0.06);
    text.add_goal("(in target right)");
    for (int i = 1; i <= request.size; ++i) {
        const std::string name = "can" + std::to_string(i);
        text.add_goal("(at " + name + " p-" + name + ")");
    }
    return std::move(text).finish();
}

}  // namespace praxis::tamp
