// Mazes from a file of fixed records, the form in which published 15x15 mazes are kept for comparison.
//
// One record a map of size M: M * M bytes of maze (row by row, 1 = free, 0 = wall), two bytes of goal (row,
// column), M * M bytes of label (0 north, 1 west, 2 south, 3 east: one optimal move a cell; any move in
// walls).
#pragma once

#include <string>

#include "learned/maps/map_problem.hpp"

namespace praxis::learned {

/// Reads all records, at most `limit` if that is not 0, and computes their distances. InputError names the
/// record that is wrong: not 0 or 1, a goal off the map or in a wall, a label that is no move or not optimal,
/// a file cut off.
MapSet read_mazes(const std::string& file, int size = 15, std::size_t limit = 0);

}  // namespace praxis::learned
