// A domain and a problem in one input, split at the first form feed (or in the middle): parsing ends with a
// task or with an InputError, never otherwise.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "parser/parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t mark = input.find('\f');
    const std::size_t at = mark == std::string_view::npos ? size / 2 : mark;
    praxis::Source domain{"domain.pddl", std::string(input.substr(0, at))};
    praxis::Source problem{"problem.pddl", std::string(input.substr(at))};
    try {
        const praxis::LoadResult result = praxis::parse_task(std::move(domain), std::move(problem));
        for (const praxis::Diagnostic& warning : result.warnings)
            praxis::to_string(warning, *result.task->sources);
    } catch (const praxis::InputError&) {
    }
    return 0;
}
