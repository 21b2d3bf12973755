// Collects what is wrong with a task while it is read, and tells it in the order of the source.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "parser/diagnostic.hpp"

namespace praxis {

class Reporter {
  public:
    static constexpr std::size_t kShown = 20;  ///< errors that are shown; the rest is counted
    static constexpr std::size_t kKept = 1000;

    void error(Location where, std::string message, std::string hint = {});
    void warning(Location where, std::string message, std::string hint = {});

    /// `construct` is what is not supported: "durative actions", say.
    void unsupported(Location where, const std::string& construct, std::string hint = {});

    /// False where so much is wrong already that another suggestion is not worth its time.
    bool wants_hints() const { return errors_ + warnings_ < kShown * 3; }
    bool has_errors() const { return errors_ > 0; }

    /// The warnings. Throws InputError if there are errors, otherwise UnsupportedError if something is
    /// unsupported.
    std::vector<Diagnostic> finish(const Sources& sources);

  private:
    void add(Severity severity, Location where, std::string message, std::string hint);

    std::vector<Diagnostic> diagnostics_;
    std::size_t errors_ = 0;
    std::size_t unsupported_ = 0;
    std::size_t warnings_ = 0;
};

}  // namespace praxis
