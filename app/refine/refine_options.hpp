// What `plan refine` was asked for.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "app/common_options.hpp"

namespace praxis::app {

struct RefineCommandOptions : CommonOptions {
    std::string domain;
    std::string problem;
    std::string streams;  ///< empty: streams.pddl beside the domain
    std::string scene;
    std::string search;  ///< an expression; empty: what suits most tasks
    std::uint64_t seed = 0;
    double speed = 1;        ///< share of the robot's limits of velocity and acceleration
    bool by_home = false;    ///< return home between actions
    std::string trajectory;  ///< files; "-": standard output; empty: none
    std::string csv;
    double csv_rate = 100;  ///< rows a second
    std::string yaml;
    std::string view;
};

/// `plan refine --generate`: makes a problem instead of solving one.
struct GenerateOptions {
    std::string family;
    int size = 0;  ///< 0: the family's smallest
    std::uint64_t seed = 1;
    bool infeasible = false;
    std::string folder;
};

/// `plan refine --list`.
struct FamilyListOptions {};

using RefineRequest = std::variant<Done, RefineCommandOptions, GenerateOptions, FamilyListOptions>;

/// Reads the command line behind `plan refine`, in reverse; prints help and usage errors itself.
RefineRequest parse_refine_command(std::vector<std::string> arguments);

}  // namespace praxis::app
