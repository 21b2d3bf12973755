// What an experiment can be told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "practice/loop/options.hpp"

namespace praxis::practice {

struct ExperimentOptions {
    std::vector<std::string> environments;  ///< expressions, see `make_environment`
    std::vector<std::string> methods;       ///< see `methods`
    std::uint64_t first_seed = 0;
    std::size_t seeds = 10;    ///< runs of each method in each environment, with seeds one after the other
    PracticeOptions practice;  ///< of all runs; its method and seed are not used
    int threads = 1;           ///< runs at a time
    std::string results;       ///< directory in which finished runs are kept; "": they are not
};

}  // namespace praxis::practice
