// The files that a run of the command leaves.
#pragma once

#include <string>

#include "search/text/output.hpp"

namespace praxis::app {

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
