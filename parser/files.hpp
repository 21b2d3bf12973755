// Files as sources.
#pragma once

#include <string>

#include "parser/source.hpp"

namespace praxis {

/// Throws an InputError that has no place in a source.
[[noreturn]] void fail_unplaced(const std::string& message);

/// Reads a file, or standard input for "-". Throws InputError.
Source read_source(const std::string& file_name);

/// Throws InputError if a source is too large or blank.
void require_text(const Source& source);

}  // namespace praxis
