// One run of a command: limits, signals, progress, the report, and an orderly end however it comes.
//
// A command calls `execute` with its body. What the body learns it puts into the report (`update`), so that a
// run that is cut off, by the watcher or by lack of memory, still gives out the best plan and the statistics.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "app/common_options.hpp"
#include "app/progress.hpp"
#include "app/report.hpp"
#include "app/watcher.hpp"
#include "parser/contingent.hpp"

namespace praxis::app {

/// How a run ends.
struct Ending {
    std::string status;
    int exit_code = 0;
    std::string message;  ///< errors; printed to standard error
};

class Run {
  public:
    Run(const CommonOptions& options, std::string command, std::string domain, std::string problem);
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    /// Runs the body, turns what it throws into an ending, writes results. Returns the exit code.
    int execute(const std::function<Ending()>& body);

    const Budget& budget() const { return budget_; }
    /// Reads domain and problem (and finds the domain file where none is named); prints warnings.
    Task load();
    /// The same for a contingent task, with files of hidden worlds.
    std::shared_ptr<const ContingentTask> load_contingent(const std::vector<std::string>& worlds);
    /// Changes the report.
    template <class Change>
    void update(Change&& change) {
        const std::scoped_lock lock(mutex_);
        std::forward<Change>(change)(report_);
    }
    /// The text that goes to standard output at the end: the best plan so far.
    void set_result(std::string text);
    /// Makes the text for standard output when the run ends, however it comes, and may write files and change
    /// the report. May be called on another thread while the body is at work, and must not call this run.
    void at_end(std::function<std::string(Report&)> conclude);
    /// What the run is busy with, for progress; a string literal.
    void set_phase(const char* phase);
    /// How much of the work is done, in [0, 1], and in words.
    void set_share(double done, std::string text);
    /// What to tell of the phase at hand, for progress.
    void set_detail(std::string text);
    void say_warnings(const std::vector<Diagnostic>& warnings, const Sources& sources);
    /// A line on standard error, unless quiet.
    void say(const std::string& line);
    bool verbose() const { return options_.verbose; }
    bool quiet() const { return options_.quiet; }
    /// The ending for a search or grounding that a stop token, time or memory ended.
    Ending stopped(Stop stop) const;

  private:
    std::pair<std::string, std::string> files();
    void tick();
    [[noreturn]] void overrun(Stop stop);
    int finish(const Ending& ending);
    Ending end_by_exception() const;
    static void on_terminate();

    const CommonOptions options_;
    std::mutex mutex_;
    Report report_;
    std::string result_;
    std::function<std::string(Report&)> conclude_;
    std::unique_ptr<Progress> progress_;
    std::unique_ptr<Watcher> watcher_;
    Budget budget_;
};

}  // namespace praxis::app
