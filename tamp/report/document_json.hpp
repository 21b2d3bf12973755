// Trajectory documents as JSON; docs/trajectory-format.md is the format.
#pragma once

#include <string>

#include "parser/source.hpp"
#include "tamp/report/trajectory_document.hpp"

namespace praxis::tamp {

/// As JSON on one line. Numbers are read back exactly as they are; text that is not UTF-8 is mended with
/// U+FFFD. Throws std::invalid_argument as `check_document` does.
std::string to_json(const TrajectoryDocument& document);

/// The inverse of `to_json`. Throws InputError, naming the file and the place in it. Members that the format
/// does not know are passed over.
TrajectoryDocument read_document(const Source& source);

}  // namespace praxis::tamp
