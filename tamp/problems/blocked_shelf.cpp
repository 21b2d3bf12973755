// A target at the back of a cell, behind blockers; it has to be brought to the table on the right. The twin
// closes the cell, takes it out of the arm's reach, or leaves no room on the right.
#include "tamp/problems/shelf.hpp"

namespace praxis::tamp {

GeneratedProblem blocked_shelf(ProblemRequest request) {
    enum class Twin { none, closed, far, narrow };
    const Twin twin = request.feasible ? Twin::none : static_cast<Twin>(1 + request.random.below(3));
    ProblemText text("pick-place", request.name,
                     "A target behind " + std::to_string(request.size) +
                         " blockers in a cell of a shelf; it has to go to the table on the right.");
    const ShelfSpace space = shelf_space();
    for (const Board& board : shelf_boards()) text.add_box(board.name, board.size, board.center);
    if (twin == Twin::closed) {
        // Bars that a stick does not pass, nor the hand.
        for (int i = -4; i <= 4; ++i) {
            text.add_box("bar" + std::to_string(i + 5), {0.01, 0.01, 0.3},
                         {space.lower[0] - 0.02, 0.06 * i, space.lower[2] + 0.16});
        }
    }
    add_shelf_tables(text);
    if (twin == Twin::narrow) {
        text.add_region("goal", "table-right", {0, 0.02}, {0.03, 0.03});
    }
    if (twin == Twin::far) {
        text.add_box("far-table", {0.3, 0.3, 0.1}, {1.5, 0, 0});
        text.add_top("far-table");
        text.add_region("goal", "far-table", {0, 0}, {0.2, 0.2});
    }
    add_shelf_things(text, request.random, request.size, space.upper[0] - 0.06);
    const bool other = twin == Twin::narrow || twin == Twin::far;
    if (other) text.add_fact("(placeable target goal)");
    text.add_goal(other ? "(in target goal)" : "(in target right)");
    return std::move(text).finish();
}

}  // namespace praxis::tamp
