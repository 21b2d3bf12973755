// The contingent optimum by brute force: all beliefs, and their costs improved until nothing changes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "belief/belief_task.hpp"

namespace praxis::belief::testing {

struct NaiveOptimum {
    /// Sum over all first states, or cost of the worst; nothing: no policy reaches the goal in all of them.
    std::optional<std::int64_t> cost;
};

/// Nothing if there are more than `most` beliefs.
std::optional<NaiveOptimum> naive_optimum(const std::shared_ptr<const BeliefTask>& task, bool worst,
                                          std::size_t most);

}  // namespace praxis::belief::testing
