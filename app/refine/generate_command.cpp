#include <cstdio>
#include <exception>

#include "app/exit_code.hpp"
#include "app/refine/refine_commands.hpp"
#include "parser/diagnostic.hpp"
#include "tamp/problems/generate.hpp"

namespace praxis::app {
namespace {

using namespace praxis::tamp;

int refuse(const std::exception& error) {
    std::fprintf(stderr, "plan: error: %s\n", error.what());
    return kInputError;
}

int smallest(const std::string& family) {
    for (const ProblemFamily& known : problem_families())
        if (known.name == family) return known.smallest;
    return 1;
}

}  // namespace

int run_generate(const GenerateOptions& options) {
    try {
        const int size = options.size > 0 ? options.size : smallest(options.family);
        const GeneratedProblem problem =
            generate_problem(options.family, size, options.seed, !options.infeasible);
        write_problem(problem, options.folder);
        std::printf(
            "%s/problem.pddl and scene.yaml are for domains/tamp/%s:\n"
            "plan refine domains/tamp/%s/domain.pddl %s/problem.pddl %s/scene.yaml\n",
            options.folder.c_str(), problem.domain.c_str(), problem.domain.c_str(), options.folder.c_str(),
            options.folder.c_str());
        return std::fflush(stdout) == 0 ? kSolved : kOutputError;
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s", error.what());
        return kOutputError;
    } catch (const std::invalid_argument& error) {
        return refuse(error);
    }
}

int run_family_list(const FamilyListOptions& /*options*/) {
    for (const ProblemFamily& family : problem_families()) {
        std::printf("%s\n    %s; size: %s, %d to %d%s\n", family.name.c_str(), family.description.c_str(),
                    family.size.c_str(), family.smallest, family.largest,
                    family.has_twin ? "; has infeasible twins" : "");
    }
    return std::fflush(stdout) == 0 ? kSolved : kOutputError;
}

}  // namespace praxis::app
