// Helpers of the tests of contingent tasks.
#pragma once

#include <string>
#include <vector>

#include "parser/contingent.hpp"
#include "tests/parser/dump.hpp"
#include "tests/parser/texts.hpp"

namespace praxis::test {

inline ContingentLoadResult parse_belief(const std::string& domain_text, const std::string& problem_text,
                                         const std::vector<std::string>& worlds = {}) {
    std::vector<Source> sources;
    for (const std::string& world : worlds) sources.push_back({"world.pddl", world});
    return parse_contingent({"domain.pddl", domain_text}, {"problem.pddl", problem_text}, std::move(sources));
}

/// What is said about a wrong contingent task; empty if it is right.
inline std::string belief_error(const std::string& domain_text, const std::string& problem_text,
                                const std::vector<std::string>& worlds = {}) {
    try {
        parse_belief(domain_text, problem_text, worlds);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

inline std::string warnings_of(const ContingentLoadResult& result) {
    std::string text;
    for (const Diagnostic& warning : result.warnings) text += to_string(warning, *result.task->task->sources);
    return text;
}

/// "(p a b)" or "(not (p a b))"
inline std::string text_of(const ContingentTask& task, const GroundLiteral& literal) {
    std::string text = '(' + task.task->predicates[literal.predicate.index()].name;
    for (const ObjectId object : literal.arguments) text += ' ' + task.task->objects[object.index()].name;
    text += ')';
    return literal.negated ? "(not " + text + ')' : text;
}

inline std::string text_of(const ContingentTask& task, const std::vector<GroundLiteral>& literals) {
    std::string text;
    for (const GroundLiteral& literal : literals) text += (text.empty() ? "" : " ") + text_of(task, literal);
    return text;
}

}  // namespace praxis::test
