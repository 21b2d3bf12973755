// The command line: what was asked, as plain values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/common_options.hpp"
#include "practice/experiment/experiment_options.hpp"

namespace praxis::app {

struct PlanOptions : CommonOptions {
    std::string domain;  ///< empty: look for it beside the problem
    std::string problem;
    std::string plan_file;  ///< empty: none
    std::string search;     ///< an expression; empty: `alias`
    std::string alias = "agile";
    int threads = 1;
    std::uint64_t seed = 0;
    bool check = true;  ///< validate plans before they are given out
};

struct ValidateOptions : CommonOptions {
    std::string domain;
    std::string problem;
    std::string plan;
};

struct GroundCommandOptions : CommonOptions {
    std::string domain;
    std::string problem;
    std::string sas;  ///< file for the SAS+ task; "-": standard output; empty: none
};

struct BeliefOptions : CommonOptions {
    /// How readings are taken: what suits the noise; all at once, a contradiction ending the run; all at
    /// once, a contradicting one being passed over; weighed until they are probable enough.
    enum class Mode : std::uint8_t { automatic, exact, sticky, bayes };

    std::string domain;
    std::string problem;
    std::vector<std::string> worlds;     ///< files with hidden worlds
    std::optional<std::size_t> runs;     ///< how many hidden worlds, evenly spread; empty: all
    std::optional<std::size_t> samples;  ///< worlds drawn from the initial uncertainty instead
    double noise = 0;                    ///< probability of a wrong reading
    double failures = 0;                 ///< probability that an action fails
    std::string observer;                ///< file that describes one; empty: readings come from the world
    std::size_t max_steps = 1000;        ///< actions of one run
    std::string policy = "plan";         ///< who chooses the actions
    Mode mode = Mode::automatic;
    double accept = 0.995;            ///< bayes: the probability from which on a fact is believed
    std::optional<double> plan_time;  ///< wall seconds for one plan
    std::string search;               ///< an expression; empty: what suits most tasks
    std::uint64_t seed = 0;
    double risk = 0;       ///< weight of -log p in the costs of assumed outcomes
    bool optimum = false;  ///< compare with the best contingent policy
    std::string trace;     ///< file for JSON lines; "-": standard output; empty: none
    std::string view;      ///< file for a page of the run; empty: none

    bool offline = false;  ///< make a conditional plan instead of acting
    std::string dot;       ///< files for the conditional plan; "-": standard output; empty: none
    std::string html;
};

struct PracticeCommandOptions : CommonOptions {
    practice::ExperimentOptions experiment;
    double threshold = 0.8;  ///< share of tasks solved to which practice is counted
    bool list = false;       ///< say what there is to choose from, and do nothing else
    std::string csv;         ///< files; "-": standard output; empty: none
    std::string summary;
    std::string svg;  ///< with several environments, each one's name is put before the ending
    std::string report;
};

struct ListOptions {
    std::string kind;  ///< evaluators, engines or aliases; empty: all
};

using Request = std::variant<Done, PlanOptions, ValidateOptions, GroundCommandOptions, BeliefOptions,
                             PracticeCommandOptions, ListOptions>;

/// Reads the command line; prints help and usage errors itself.
Request parse_command_line(int argc, const char* const* argv);
/// `plan belief` and `plan practice`, in files of their own; arguments in reverse.
Request parse_belief_command(std::vector<std::string> arguments);
Request parse_practice_command(std::vector<std::string> arguments);

}  // namespace praxis::app
