// Writing results: all of it or an error, never half a file.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace praxis::app {

/// A result could not be written (exit code 35).
class OutputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Writes to standard output and flushes. Throws OutputError.
void write_standard_output(std::string_view text);

/// Replaces the file (or, for "-", writes to standard output). Readers see the old or the new content, never
/// a part. Devices and pipes are written to directly. Throws OutputError.
void write_file(const std::string& path, std::string_view text);

/// Both names are of one and the same existing file.
bool same_file(const std::string& a, const std::string& b);

/// The plan files of one run: FILE is always the best plan; where there are several, they are FILE.1, FILE.2,
/// ... as well.
class PlanFiles {
  public:
    /// Removes the plan files of an earlier run. An empty path: no files are written.
    explicit PlanFiles(std::string path);
    void write(const std::string& text);

  private:
    std::string path_;
    std::string first_;
    int count_ = 0;
};

}  // namespace praxis::app
