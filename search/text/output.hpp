// Writing results: all of it or an error, never half a file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace praxis {

/// A result could not be written.
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes to standard output and flushes. Throws OutputError.
void write_standard_output(std::string_view text);

/// Replaces the file (or, for "-", writes to standard output). Readers see the old or the new content, never
/// a part. Devices and pipes are written to directly. Throws OutputError.
void write_file(const std::string& path, std::string_view text);

}  // namespace praxis
