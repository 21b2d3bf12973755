// Helpers of the parser's tests: tasks from short texts.
#pragma once

#include <string>
#include <string_view>

#include "parser/parser.hpp"

namespace praxis::test {

inline LoadResult parse(const std::string& domain, const std::string& problem) {
    return parse_task({"domain.pddl", domain}, {"problem.pddl", problem});
}

/// A domain around some sections.
inline std::string domain(const std::string& sections) {
    return "(define (domain d) (:requirements :adl :derived-predicates :action-costs)\n" + sections + ")\n";
}

/// A problem around some sections.
inline std::string problem(const std::string& sections) {
    return "(define (problem p) (:domain d)\n" + sections + ")\n";
}

/// A problem with nothing but a trivial goal.
inline std::string empty_problem() {
    return problem("(:goal (and))");
}

/// What is said about a wrong input; empty if it is right.
inline std::string error_of(const std::string& domain_text, const std::string& problem_text) {
    try {
        parse(domain_text, problem_text);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

inline bool is_unsupported(const std::string& domain_text, const std::string& problem_text) {
    try {
        parse(domain_text, problem_text);
    } catch (const UnsupportedError&) {
        return true;
    } catch (const InputError&) {
    }
    return false;
}

/// The text of all warnings.
inline std::string warnings_of(const LoadResult& result) {
    std::string text;
    for (const Diagnostic& warning : result.warnings) text += to_string(warning, *result.task->sources);
    return text;
}

inline bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

}  // namespace praxis::test
