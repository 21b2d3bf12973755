#include "belief/perception/assignment.hpp"

#include <limits>

namespace praxis::belief {

std::vector<std::size_t> assign(const std::vector<double>& costs, std::size_t rows, std::size_t columns) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const std::size_t none = rows;      // a column without a row
    const std::size_t start = columns;  // a column beyond the last, where each search begins
    std::vector<double> row_potential(rows, 0);
    std::vector<double> column_potential(columns + 1, 0);
    std::vector<std::size_t> row_of(columns + 1, none);
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<double> reached(columns, kInfinite);
        std::vector<std::size_t> from(columns, start);
        std::vector<bool> visited(columns + 1, false);
        std::size_t at = start;
        row_of[start] = row;
        do {
            visited[at] = true;
            const std::size_t i = row_of[at];
            double least = kInfinite;
            std::size_t next = start;
            for (std::size_t j = 0; j < columns; ++j) {
                if (visited[j]) continue;
                const double slack = costs[i * columns + j] - row_potential[i] - column_potential[j];
                if (slack < reached[j]) {
                    reached[j] = slack;
                    from[j] = at;
                }
                if (reached[j] < least) {
                    least = reached[j];
                    next = j;
                }
            }
            for (std::size_t j = 0; j <= columns; ++j) {
                if (visited[j]) {
                    row_potential[row_of[j]] += least;
                    column_potential[j] -= least;
                } else if (j < columns) {
                    reached[j] -= least;
                }
            }
            at = next;
        } while (row_of[at] != none);
        while (at != start) {
            row_of[at] = row_of[from[at]];
            at = from[at];
        }
        row_of[start] = none;
    }
    std::vector<std::size_t> result(rows, columns);
    for (std::size_t j = 0; j < columns; ++j) {
        if (row_of[j] != none) result[row_of[j]] = j;
    }
    return result;
}

}  // namespace praxis::belief
