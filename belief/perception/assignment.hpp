// The assignment problem: rows to columns, one to one, at the least cost.
#pragma once

#include <cstddef>
#include <vector>

namespace praxis::belief {

/// The column of each row such that the sum of costs[row * columns + column] is least. Needs rows <= columns
/// and finite costs. O(rows^2 columns): shortest augmenting paths with potentials (Kuhn 1955; Jonker &
/// Volgenant 1987).
std::vector<std::size_t> assign(const std::vector<double>& costs, std::size_t rows, std::size_t columns);

}  // namespace praxis::belief
