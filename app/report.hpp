// What a run of the command has to tell, as values and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "search/session.hpp"
#include "search/validate.hpp"

namespace praxis::app {

/// One run under partial observability.
struct BeliefRun {
    std::size_t world = 0;
    std::string status;          ///< "reached", "infeasible", ...
    bool success = false;        ///< the goal holds in the world at the end, by the independent check
    bool false_success = false;  ///< believed only
    bool infeasible = false;     ///< it is proved that nobody can reach the goal
    std::string message;
    std::string error;                 ///< the observer is out of order, and why
    std::vector<std::string> actions;  ///< tried; some may have failed
    std::size_t failures = 0;          ///< how many of them did
    std::vector<std::string> found;    ///< objects, in the order in which they were found
    std::size_t plans = 0;
    double processor_seconds = 0;
    double search_seconds = 0;  ///< of these in searches
    double longest_search = 0;
    /// What the run cost, actions that the world refused included; like the next two in the task's units.
    double length = 0;
    std::optional<double> policy_cost;      ///< of the best contingent policy in this world
    std::optional<double> omniscient_cost;  ///< of the best plan of one who knows this world
};

/// A conditional plan, or why there is none.
struct OfflineReport {
    std::string status;  ///< "found", "unsolvable", "not found", ...
    std::string message;
    std::string plan;  ///< as JSON; empty: none was found
    std::size_t actions = 0;
    std::size_t edges = 0;
    std::size_t depth = 0;
    double mean_cost = 0;
    double worst_cost = 0;
    double mean_actions = 0;
    std::size_t checked_worlds = 0;
    bool all_worlds = false;
    bool optimal = false;
    std::size_t searches = 0;
    double processor_seconds = 0;
};

/// One run; the JSON report has these names.
struct Report {
    std::string command;
    std::string status;  ///< "solved", "unsolvable", "out_of_time", "input_error", "valid", ...
    int exit_code = 0;
    std::string message;  ///< errors and verdicts in words; may be empty
    std::string domain;   ///< file names
    std::string problem;
    std::optional<Configuration> configuration;
    std::string alias;
    Task task;  ///< for names; null if it could not be loaded
    std::optional<Plan> plan;
    bool optimal = false;
    bool lifted = false;  ///< planned without grounding
    std::optional<SearchStatistics> statistics;
    std::vector<PhaseStatistics> phases;
    std::optional<Verdict> verdict;
    std::vector<BeliefRun> runs;
    std::optional<OfflineReport> offline;
    std::string practice;  ///< the figures of an experiment, as JSON; empty: there are none
    std::string refine;    ///< what a refinement found, as JSON; empty: nothing
};

/// The report as JSON, ending with a newline.
std::string to_json(const Report& report);

/// The name of a status in reports, and its exit code.
const char* status_name(Status status);
int exit_code(Status status);

/// Seconds since the process started.
double elapsed_seconds();
/// Notes the start; called first thing in main.
void start_clock();

/// "1.2 ms", "34.5 s"; "12 MiB"; "1234567" with the separator of thousands "1,234,567".
std::string seconds_text(double seconds);
std::string bytes_text(std::size_t bytes);
std::string count_text(std::uint64_t count);

}  // namespace praxis::app
