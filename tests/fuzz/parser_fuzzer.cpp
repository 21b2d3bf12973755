// A domain and a problem in one input, split at the first form feed (or in the middle): parsing ends with a
// task or with an InputError, never otherwise. As a contingent task, it is also written and read back.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "parser/parser.hpp"
#include "tests/parser/dump.hpp"

namespace {

void try_classical(const praxis::Source& domain, const praxis::Source& problem) {
    try {
        const praxis::LoadResult result = praxis::parse_task(domain, problem);
        for (const praxis::Diagnostic& warning : result.warnings)
            praxis::to_string(warning, *result.task->sources);
    } catch (const praxis::InputError&) {
    }
}

void try_contingent(const praxis::Source& domain, const praxis::Source& problem) {
    std::shared_ptr<const praxis::ContingentTask> task;
    try {
        task = praxis::parse_contingent(domain, problem).task;
    } catch (const praxis::InputError&) {
        return;
    }
    try {
        const auto again = praxis::parse_contingent({"domain", praxis::write_contingent_domain(*task)},
                                                    {"problem", praxis::write_contingent_problem(*task)})
                               .task;
        if (praxis::test::dump(*task) != praxis::test::dump(*again)) std::abort();
    } catch (const praxis::InputError& error) {
        // Flattened effects may be nested deeper than what they were made of.
        if (std::string_view(error.what()).find("nested") == std::string_view::npos) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t mark = input.find('\f');
    const std::size_t at = mark == std::string_view::npos ? size / 2 : mark;
    const praxis::Source domain{"domain.pddl", std::string(input.substr(0, at))};
    const praxis::Source problem{"problem.pddl", std::string(input.substr(at))};
    try_classical(domain, problem);
    try_contingent(domain, problem);
    return 0;
}
