// What the command lines of all commands have in common.
#pragma once

#include <optional>
#include <string>

namespace praxis::app {

/// Options that every command has.
struct CommonOptions {
    bool quiet = false;                     ///< nothing on standard error but errors
    bool verbose = false;                   ///< phases and statistics on standard error
    std::string json;                       ///< file for the report; "-": standard output; empty: none
    std::optional<double> time_limit;       ///< wall seconds of the whole process
    std::optional<double> memory_limit_mb;  ///< resident memory of the process, MiB
};

/// Nothing is left to do (help, version, wrong usage): the process ends with this code.
struct Done {
    int exit_code = 0;
};

}  // namespace praxis::app
