// The public header of praxis::parser: PDDL text in, a checked lifted task out.
#pragma once

#include <string>
#include <vector>

#include "parser/diagnostic.hpp"
#include "parser/task.hpp"

namespace praxis {

/// A task and what is worth telling its author.
struct LoadResult {
    Task task;
    std::vector<Diagnostic> warnings;
};

/// Reads, parses and checks a domain and a problem file ("-": standard input, for one of the two).
/// Throws InputError (unreadable, malformed or inconsistent input; all errors found, in order) or UnsupportedError.
LoadResult load_with_warnings(const std::string& domain_file, const std::string& problem_file);

/// The same, without the warnings.
Task load(const std::string& domain_file, const std::string& problem_file);

/// The same from texts in memory; the names of the sources appear in messages.
LoadResult parse_task(Source domain, Source problem);

/// The domain file for a problem file, found beside it as Fast Downward does: DIR/domain.pddl, DIR/PROBLEM-domain.pddl, ...
/// Throws InputError, naming the candidates tried, if there is none.
std::string find_domain_file(const std::string& problem_file);

}  // namespace praxis
