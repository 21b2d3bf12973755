// Small tasks written in PDDL.
#pragma once

#include <string>

#include "parser/parser.hpp"

namespace praxis::test {

/// A task of one type "thing" with three things a, b, c unless said otherwise.
inline Task task_of(const std::string& domain_body, const std::string& init, const std::string& goal,
                    const std::string& more = "", const std::string& objects = "a b c - thing") {
    const std::string domain = "(define (domain d) (:requirements :adl :derived-predicates :action-costs)\n" +
                               std::string("(:types thing nothing)\n") + domain_body + ")";
    const std::string problem = "(define (problem p) (:domain d) (:objects " + objects + ")\n(:init " + init +
                                ")\n(:goal " + goal + ")" + more + ")";
    return parse_task({"domain.pddl", domain}, {"problem.pddl", problem}).task;
}

}  // namespace praxis::test
