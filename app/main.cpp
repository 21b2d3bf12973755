#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <exception>
#include <variant>

#include "app/commands.hpp"
#include "app/exit_code.hpp"
#include "app/refine_launch.hpp"
#include "app/report.hpp"

namespace {

using namespace praxis::app;

int dispatch(const Request& request) {
    return std::visit(
        [](const auto& options) {
            using Options = std::decay_t<decltype(options)>;
            if constexpr (std::is_same_v<Options, Done>) return options.exit_code;
            if constexpr (std::is_same_v<Options, PlanOptions>) return run_plan(options);
            if constexpr (std::is_same_v<Options, ValidateOptions>) return run_validate(options);
            if constexpr (std::is_same_v<Options, GroundCommandOptions>) return run_ground(options);
            if constexpr (std::is_same_v<Options, BeliefOptions>) return run_belief(options);
            if constexpr (std::is_same_v<Options, PracticeCommandOptions>)
                return run_practice_command(options);
            if constexpr (std::is_same_v<Options, ListOptions>) return run_list(options);
        },
        request);
}

}  // namespace

int main(int argc, char** argv) {
    start_clock();
    if (argc > 1 && std::strcmp(argv[1], "refine") == 0) return launch_refine(argc, argv);
    int exit_code = kInternalError;
    try {
        exit_code = dispatch(parse_command_line(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "plan: internal error: %s\n", error.what());
    }
    std::fflush(nullptr);
    // The watcher's thread is still there, and tearing down large tables takes time: leave without ceremony.
    _exit(exit_code);
}
