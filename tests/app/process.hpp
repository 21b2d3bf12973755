// Runs the command as its users do.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace praxis::test {

struct Outcome {
    int exit_code = -1;  ///< 128 + N if signal N killed it
    bool killed = false;
    std::string out;
    std::string err;
    double seconds = 0;
};

struct Circumstances {
    std::string input = {};                            ///< standard input
    std::vector<std::pair<double, int>> signals = {};  ///< after so many seconds, this signal
    std::function<bool()> ready = {};                  ///< the seconds count from when this is true
    std::function<void()> prepare = {};                ///< called in the child before the command starts
    bool close_output = false;                         ///< nobody reads standard output
};

/// Runs build/bin/plan with the arguments; fails the test if it takes more than a minute.
Outcome plan(const std::vector<std::string>& arguments, const Circumstances& circumstances = {});
/// The same with another program.
Outcome run(const std::string& program, const std::vector<std::string>& arguments,
            const Circumstances& circumstances = {});

/// A folder that is removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string operator/(const std::string& name) const { return path_ + "/" + name; }
    /// Writes a file and returns its path.
    std::string write(const std::string& name, const std::string& text) const;
    std::vector<std::string> names() const;

  private:
    std::string path_;
};

std::string read_file(const std::string& path);
bool contains(const std::string& text, const std::string& part);
/// Paths of our own tasks.
std::string domain_of(const std::string& name);
std::string problem_of(const std::string& name, const std::string& size);

}  // namespace praxis::test
