// Contingent tasks from texts in memory.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "belief/knowledge_planner.hpp"
#include "parser/contingent.hpp"

namespace praxis::belief::test {

struct Texts {
    std::string domain;
    std::string problem;
    std::vector<std::string> worlds = {};
};

inline std::shared_ptr<const BeliefTask> ground(const Texts& texts) {
    std::vector<Source> worlds;
    for (const std::string& world : texts.worlds) worlds.push_back({"world.pddl", world});
    const ContingentLoadResult loaded =
        parse_contingent({"domain.pddl", texts.domain}, {"problem.pddl", texts.problem}, std::move(worlds));
    return ground_belief(loaded.task).task;
}

inline std::shared_ptr<const Compilation> compile(const std::shared_ptr<const BeliefTask>& task) {
    return std::make_shared<const Compilation>(task);
}

/// A task of atoms without parameters.
inline Texts propositional(const std::string& predicates, const std::string& domain_body,
                           const std::string& init, const std::string& goal, const std::string& more = "") {
    return {"(define (domain d) (:predicates " + predicates + ")\n" + domain_body + ")",
            "(define (problem p) (:domain d)\n(:init " + init + ")\n(:goal " + goal + ")" + more + ")"};
}

/// The fact of an atom "(p a)" of the physical task; its variable is -1 if it has none.
inline Fact fact_of(const BeliefTask& task, const std::string& atom) {
    const FiniteDomainTask& physical = *task.physical;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(physical.variable_count()); ++v)
        for (std::int32_t value = 0; value < physical.domain_sizes[static_cast<std::size_t>(v)]; ++value) {
            const std::uint32_t number = physical.fact_number({v, value});
            if (physical.is_atom({v, value}) && "(" + physical.fact_names.words(number) + ")" == atom)
                return {v, value};
        }
    return {-1, 0};
}

/// The operator of that name, "(move a b)"; as many as there are operators if there is none.
inline std::uint32_t action_of(const BeliefTask& task, const std::string& name) {
    std::uint32_t action = 0;
    while (action < task.operator_count() && task.physical->operator_name(OperatorId(action)) != name)
        ++action;
    return action;
}

}  // namespace praxis::belief::test
