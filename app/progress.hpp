// Progress on standard error: a line that updates in place on a terminal, plain lines otherwise.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "search/engines/search.hpp"

namespace praxis::app {

/// Not thread-safe.
class Progress {
  public:
    explicit Progress(bool shown);

    void set_phase(const char* phase) {
        phase_ = phase;
        detail_.clear();
    }
    void set_statistics(const SearchStatistics& statistics);
    /// Of the work that is known beforehand, this fraction is done; `text` says more.
    void set_share(double done, std::string text);
    /// What to tell of the phase at hand.
    void set_detail(std::string text) { detail_ = std::move(text); }
    /// Shows how far things are, if enough time has passed since the last time.
    void show();
    /// Prints a line of its own.
    void print(const std::string& line);
    /// Removes the updating line.
    void clear();
    /// How often `show` is worth calling; nothing is shown before the first second.
    std::chrono::milliseconds interval() const;

  private:
    std::string line() const;
    std::string share_line() const;

    bool shown_;
    bool terminal_;
    bool visible_ = false;
    const char* phase_ = "starting";
    SearchStatistics statistics_;
    bool searching_ = false;
    std::optional<double> share_;
    std::string share_text_;
    std::string detail_;
    double next_ = 1;
    double step_ = 1;
};

}  // namespace praxis::app
