// Points out of files: PCD (ascii and binary), PLY (ascii and little-endian binary), and text.
#pragma once

#include <vector>

#include "parser/source.hpp"
#include "tamp/geometry/pose.hpp"

namespace praxis::tamp {

/// The points of a file, of which the first line tells the format; `file` holds its bytes and its name. Text
/// has a point a line: three numbers (others may follow) between blanks, commas or semicolons; lines that
/// begin with # are skipped, and so is a first line of column names. Points that are not finite are kept out.
/// Throws InputError naming the line or what the header lacks. Limit: 50 million points.
std::vector<Vector3> parse_points(const Source& file);

}  // namespace praxis::tamp
