#include "parser/write.hpp"

#include "parser/write/sections.hpp"

namespace praxis {

std::string write_domain(const LiftedTask& task) {
    std::string out;
    write::domain_head(task, "", out);
    write::axioms(task, out);
    for (const Schema& schema : task.schemas) write::schema(task, schema, {}, out);
    return out + ")\n";
}

std::string write_problem(const LiftedTask& task) {
    std::string out = "(define (problem " + task.problem_name + ")\n  (:domain " + task.domain_name + ")\n";
    std::vector<bool> own = write::constants(task);
    own.flip();
    write::objects(task, ":objects", own, out);
    out += "  (:init\n";
    write::initial_facts(task, out);
    out += "  )\n";
    write::goal(task, out);
    return out + ")\n";
}

}  // namespace praxis
