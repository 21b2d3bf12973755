// Where actions are executed and what can be read afterwards, in ground terms. What the loop works with; a
// robot's program implements `Skills` and `Observer` (robot.hpp), which `RobotEnvironment` joins.
#pragma once

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "belief/belief_task.hpp"
#include "belief/robot.hpp"

namespace praxis::belief {

/// An answer: `fact` holds, or its opposite does.
struct Answer {
    Fact fact;            ///< what is said to hold
    double accuracy = 1;  ///< probability that it is so
};

class Environment {
  public:
    static constexpr std::uint32_t kStart = 0xffffffff;

    virtual ~Environment() = default;
    /// Executes an operator of the physical task.
    virtual Execution execute(std::uint32_t action, std::stop_token stop) = 0;
    /// What is read after `action` (kStart: before the first one).
    virtual std::vector<Answer> observe(std::uint32_t action, std::stop_token stop) = 0;
    /// Objects have been found that the task does not have: the run ends, for it to grow.
    virtual bool found_objects() const { return false; }
};

}  // namespace praxis::belief
