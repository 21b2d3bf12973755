// How the grounder refuses what it cannot ground.
#pragma once

#include <string>
#include <utility>

#include "parser/diagnostic.hpp"
#include "parser/task.hpp"

namespace praxis::grounding {

/// Throws UnsupportedError with the place in the task's source.
[[noreturn]] inline void refuse(const LiftedTask& task, Location where, std::string message) {
    const Diagnostic diagnostic{Severity::unsupported, where, true, std::move(message), ""};
    throw UnsupportedError(to_string(diagnostic, *task.sources), {diagnostic});
}

}  // namespace praxis::grounding
