// `plan refine`: the program that `plan` becomes for it.
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <variant>

#include "app/exit_code.hpp"
#include "app/refine/refine_commands.hpp"
#include "app/report.hpp"

namespace {

using namespace praxis::app;

int dispatch(const RefineRequest& request) {
    return std::visit(
        [](const auto& options) {
            using Options = std::decay_t<decltype(options)>;
            if constexpr (std::is_same_v<Options, Done>) return options.exit_code;
            if constexpr (std::is_same_v<Options, RefineCommandOptions>) return run_refine(options);
            if constexpr (std::is_same_v<Options, GenerateOptions>) return run_generate(options);
            if constexpr (std::is_same_v<Options, FamilyListOptions>) return run_family_list(options);
        },
        request);
}

}  // namespace

int main(int argc, char** argv) {
    start_clock();
    int exit_code = kInternalError;
    try {
        // CLI11 wants the arguments in reverse.
        std::vector<std::string> arguments;
        for (int i = argc - 1; i >= 1; --i) arguments.emplace_back(argv[i]);
        exit_code = dispatch(parse_refine_command(std::move(arguments)));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "plan: internal error: %s\n", error.what());
    }
    std::fflush(nullptr);
    // The watcher's thread is still there.
    _exit(exit_code);
}
