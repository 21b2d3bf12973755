// Random PDDL tasks in which things move: enough structure for invariants, enough disorder to break some.
#pragma once

#include <cstdint>
#include <string>

#include "parser/parser.hpp"

namespace praxis::test {

struct MovingTask {
    std::string domain;
    std::string problem;
    Task task;
};

/// The same seed gives the same task.
MovingTask moving_task(std::uint32_t seed);

}  // namespace praxis::test
